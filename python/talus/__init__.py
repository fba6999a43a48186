# SPDX-License-Identifier: MIT
"""Talus: slope stability and runout by the material point method.

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

# OpenMP reads this when it is loaded, with the extension module below. Threads that spin while they wait take the cores
# from those that they wait for (src/app/wait_policy.cpp does the same for the program).
_wait_policy = {"OMP_WAIT_POLICY": "passive", "GOMP_SPINCOUNT": "20000"}
if "OMP_WAIT_POLICY" in _os.environ:
    _wait_policy = {}
_wait_policy = {name: value for name, value in _wait_policy.items() if name not in _os.environ}
_os.environ.update(_wait_policy)
from . import _core  # noqa: E402

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
