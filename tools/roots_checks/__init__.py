# SPDX-License-Identifier: MIT
"""Checks of the vegetated slope, for verify_roots.py."""
