import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Optional, Union

from .result import Result
from .scene import Scene

Number = Union[int, float, str]
Flag = Optional[bool]
Whole = Union[int, str, None]
Value = Union[int, float, str, Iterable[Union[int, float]], Mapping[str, Any], None]
Values = Union[int, float, str, Iterable[Any], Mapping[str, Any], None]
Table = Union[str, os.PathLike[str], Result, Any]
What = Union[Scene, Result, str, os.PathLike[str], Iterable[Any], None]
Progress = Union[Callable[[str, float, float], object], bool, None]
