#!/usr/bin/env bash
# scikit-image 0.19.3 (Debian 12's): regionprops gives an ellipse's centroid by row and column, so that y points down, and its
# `orientation` in the other sense: counted from the axis of rows, it grows when the body turns counter-clockwise as the image
# is seen, where the direction of its major axis in the same coordinates, atan2(rows, columns), falls. The two add up to a
# quarter of a turn. Trackers that write both in one table (OCTRON: pos_x, pos_y, orientation) so need their y axis turned for
# places and not for the angle: the sign of a spin depends on which column it is taken from.
# On Debian 12, with its python3-scipy: two packages in a temporary folder.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"  # apt fetches as a user of its own
cd "$folder"
apt-get download --quiet python3-skimage=0.19.3-8 python3-skimage-lib=0.19.3-8+b1
for package in ./*.deb; do dpkg-deb --extract "$package" root; done
PYTHONPATH=root/usr/lib/python3/dist-packages /usr/bin/python3 - <<'END'
import math

import numpy
import skimage
from skimage.measure import regionprops

print("scikit-image", skimage.__version__)
assert skimage.__version__ == "0.19.3"
rows, columns = numpy.mgrid[0:401, 0:401] - 200.0


def ellipse(degrees):
    """Its major axis at so many degrees from the x axis, counter-clockwise as the image is seen."""
    a = math.radians(degrees)
    along, across = columns * math.cos(a) - rows * math.sin(a), columns * math.sin(a) + rows * math.cos(a)
    return ((along / 150) ** 2 + (across / 40) ** 2 <= 1).astype(int)


found = []
for degrees in (10, 40, 70):
    mask = ellipse(degrees)
    orientation = math.degrees(regionprops(mask)[0].orientation) % 180
    y, x = rows[mask == 1], columns[mask == 1]
    in_image = math.degrees(0.5 * math.atan2(2 * (x * y).mean(), (x * x).mean() - (y * y).mean())) % 180
    print(f"turned by {degrees}: orientation {orientation:.1f}, atan2 of rows and columns {in_image:.1f} degrees")
    assert abs((orientation + in_image) % 180 - 90) < 0.5
    found.append(orientation)
assert found[0] < found[1] < found[2] and abs(found[2] - found[0] - 60) < 0.5
END
