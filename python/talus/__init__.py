# SPDX-License-Identifier: MIT
"""Talus: slope stability and runout by LEM, FEM, limit analysis and MPM.

    case = talus.Case.read("case.toml")        # or talus.Case(geometry=dict(...), materials=dict(...), ...)
    case.materials["sand"].cohesion = "3 kPa"  # the names and units of `talus manual`
    results = talus.run(case, "results")
    print(results.factor_of_safety)
    talus.plot.plot_section(results)
    study = talus.study(case, "study", {"mesh.size": [1, 0.5]})
    print(study.table["mesh.size"], study.table["FoS, frozen"])

Frames are in SI units, histories in the units of [output], stress is positive in tension. Errors are talus.Error.
"""

import os as _os
import subprocess as _subprocess

# OpenMP reads this when it is loaded, with the extension module below. Threads that spin while they wait take the cores
# from those that they wait for (src/app/wait_policy.cpp does the same for the program).
_wait_policy = {"OMP_WAIT_POLICY": "passive", "GOMP_SPINCOUNT": "20000"}
if "OMP_WAIT_POLICY" in _os.environ:
    _wait_policy = {}
_wait_policy = {name: value for name, value in _wait_policy.items() if name not in _os.environ}
_os.environ.update(_wait_policy)
# A package has the compiled part for several levels of the instruction set; its program knows which one this processor takes.
_here = _os.path.dirname(__file__)
if _os.path.isdir(_os.path.join(_here, "levels")):
    _told = _subprocess.run([_os.path.join(_here, "levels", "talus"), "--level"], capture_output=True, text=True)
    if _told.returncode != 0:
        raise ImportError(_told.stderr.strip())
    __path__.append(_os.path.join(_here, "levels", _told.stdout.strip()))
    _units = _os.path.join(_here, "levels", "units", "udunits2.xml")  # a wheel carries the database of units
    if _os.path.exists(_units):
        _os.environ.setdefault("UDUNITS2_XML_PATH", _units)
try:
    from . import _core  # noqa: E402
except ImportError:
    if any(_name.startswith("_core.") and not _name.endswith(".pyi") for _folder in __path__ for _name in _os.listdir(_folder)):
        raise  # a library that it needs is missing: the loader has said which
    raise ImportError(
        f"the compiled part of talus is not in {_here}: `make program` in the folder of the sources "
        "builds it into build/release/python, which belongs in PYTHONPATH"
    ) from None

if _os.environ.get("TALUS_LEVEL") not in (None, "", _core.level):
    raise ImportError(f"TALUS_LEVEL is '{_os.environ['TALUS_LEVEL']}', and this package is compiled for {_core.level} alone")
for _name in _wait_policy:
    del _os.environ[_name]

from . import plot  # noqa: E402
from .calculation import Progress, run, study  # noqa: E402
from .case import Case, describe  # noqa: E402
from .errors import CannotWrite, Error, Finding, FolderExists, InputError, Interrupted, NotEnoughMemory, Unstable  # noqa: E402
from .fields import Fields, History  # noqa: E402
from .frames import Frame, Mesh  # noqa: E402
from .methods import MethodFactor, MethodTable, Surface  # noqa: E402
from .named import Comparison, Result  # noqa: E402
from .records import Record  # noqa: E402
from .results import Results  # noqa: E402
from .studies import Study  # noqa: E402

__version__: str = _core.version

__all__ = [
    "CannotWrite",
    "Case",
    "Comparison",
    "Error",
    "Fields",
    "Finding",
    "FolderExists",
    "Frame",
    "History",
    "InputError",
    "Interrupted",
    "Mesh",
    "MethodFactor",
    "MethodTable",
    "NotEnoughMemory",
    "Progress",
    "Record",
    "Result",
    "Results",
    "Study",
    "Surface",
    "Unstable",
    "describe",
    "plot",
    "run",
    "study",
]
