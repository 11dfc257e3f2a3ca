"""What pyproject.toml cannot say of the Python package: its version, and that a build leaves nothing beside the
sources."""

import pathlib
import re
import tempfile

from setuptools import setup

declared = (pathlib.Path(__file__).resolve().parents[1] / "CMakeLists.txt").read_text()
with tempfile.TemporaryDirectory() as folder:
    setup(version=re.search(r"project\(softwet VERSION ([0-9.]+)", declared)[1],
          options={"build": {"build_base": folder}, "egg_info": {"egg_base": folder}})
