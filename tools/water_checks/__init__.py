# SPDX-License-Identifier: MIT
"""The verification problems of coupled water: each module runs one, compares it with its closed form and draws it."""
