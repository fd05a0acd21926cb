"""Writes the GL entry points from the Khronos registry and tools/policy.toml; see tools/generate.py."""
