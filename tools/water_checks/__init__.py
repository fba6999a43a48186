"""The verification problems of coupled water: each module runs one, holds it against its closed form and draws it."""
