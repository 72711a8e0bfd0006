"""Checks package.xml as ROS's tools read it. Exit status 77 if catkin_pkg is not there."""

import re
import sys
from pathlib import Path

sys.path.append("/usr/lib/python3/dist-packages")  # where Debian puts it, whatever python3 is first in PATH
try:
    from catkin_pkg.package import parse_package
except ImportError:
    print("catkin_pkg (package python3-catkin-pkg) is not there")
    sys.exit(77)


def main(root, version):
    warnings = []
    package = parse_package(str(root / "package.xml"), warnings=warnings)
    package.validate(warnings=warnings)
    assert not warnings, warnings
    assert package.version == version, f"package.xml says {package.version}, CMakeLists.txt {version}"
    cited = re.search(r"^version: (.+)$", (root / "CITATION.cff").read_text(), re.M).group(1)
    assert cited == version, f"CITATION.cff says {cited}, CMakeLists.txt {version}"
    assert package.get_build_type() == "cmake"
    keys = {depend.name for depend in package.build_depends + package.test_depends}
    # FCL and OctoMap have to be the distribution's, as MoveIt's are: ROS has an octomap of its own, of another ABI.
    assert {"ompl", "libfcl-dev", "liboctomap-dev"} <= keys, keys
    assert not {"fcl", "octomap", "boost"} & keys, keys


main(Path(sys.argv[1]), sys.argv[2])
