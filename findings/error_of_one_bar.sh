#!/usr/bin/env bash
# matplotlib 3.10.1 with NumPy 2.2.4 (Debian 13's): the errors of one bar (bar's yerr, barh's xerr), given as an array of shape
# (2, 1), lower and upper, raise NumPy's DeprecationWarning "Conversion of an array with ndim > 0 to a scalar", which is to
# become an error. The same array is taken by errorbar without a word; as lists, or of two bars, it is taken by all of them.
# bar makes a list of rows of the array; cbook._safe_first_finite hands the first row to math.isfinite, which takes a row of one
# for a number and refuses longer ones. So a chart whose number of bars depends on the data warns, and is to fail, for one alone.
# As root, with mmdebstrap: a root of these packages alone, in a temporary folder.
set -euo pipefail
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mmdebstrap --quiet --variant=apt --include=python3-matplotlib trixie "$root/trixie"
chroot "$root/trixie" /usr/bin/python3 - <<'END'
import warnings
import matplotlib
matplotlib.use("agg")
import matplotlib.pyplot as pyplot
import numpy

print("matplotlib", matplotlib.__version__, "NumPy", numpy.__version__)
assert (matplotlib.__version__, numpy.__version__) == ("3.10.1+dfsg1", "2.2.4")


def warned_of(draw):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        draw(pyplot.subplots()[1])
    return sorted({str(warning.message)[:70] for warning in caught})


for bars in (1, 2):
    places, errors = numpy.arange(bars), numpy.full((2, bars), 0.5)
    found = {"bar": warned_of(lambda axes: axes.bar(places, places, yerr=errors)),
             "barh": warned_of(lambda axes: axes.barh(places, places, xerr=errors)),
             "barh, lists": warned_of(lambda axes: axes.barh(places, places, xerr=errors.tolist())),
             "errorbar": warned_of(lambda axes: axes.errorbar(places, places, yerr=errors))}
    print(f"array of shape {errors.shape}:", found)
    deprecated = ["Conversion of an array with ndim > 0 to a scalar is deprecated, and wi"] if bars == 1 else []
    assert found == {"bar": deprecated, "barh": deprecated, "barh, lists": [], "errorbar": []}
END
