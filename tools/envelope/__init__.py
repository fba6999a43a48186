# SPDX-License-Identifier: MIT
"""The slopes of the source as an envelope over what it leaves open, for verify_envelope.py."""
