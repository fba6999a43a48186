#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tools/setup.sh on machines that lack packages, with scripts in the place of dpkg-query, apt-get and id."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
QUERY = """#!/bin/sh
shift 2
for package; do grep -qx "$package" "$MACHINE/installed" && echo "installed $package"; done
exit 0
"""
GET = """#!/bin/sh
echo "$@" >>"$MACHINE/calls"
[ "$1" = update ] && exit 0
shift 4
for package; do grep -qx "$package" "$MACHINE/offered" || exit 100; done
printf '%s\\n' "$@" >>"$MACHINE/installed"
"""


class Setup(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.machine = pathlib.Path(scratch.name)
        (self.machine / "tools").mkdir()
        shutil.copy(TOOLS / "setup.sh", self.machine / "tools")
        (self.machine / "tools/apt-packages.txt").write_text("# needed\ngood   # it\nsound\n")
        (self.machine / "tools/apt-packages-drawings.txt").write_text("extra\n")
        (self.machine / "bin").mkdir()
        for name, text in (("dpkg-query", QUERY), ("apt-get", GET), ("id", "#!/bin/sh\necho 0\n")):
            (self.machine / "bin" / name).write_text(text)
            (self.machine / "bin" / name).chmod(0o755)

    def set_up(self, *lists, installed="", offered="good sound extra"):
        for name, words in (("installed", installed), ("offered", offered)):
            (self.machine / name).write_text("".join(f"{word}\n" for word in words.split()))
        (self.machine / "calls").write_text("")
        environment = dict(os.environ, MACHINE=str(self.machine), PATH=f"{self.machine}/bin:{os.environ['PATH']}")
        done = subprocess.run([self.machine / "tools/setup.sh", *lists], env=environment, capture_output=True, text=True)
        return done.returncode, done.stdout, (self.machine / "calls").read_text().splitlines(), (self.machine / "installed").read_text().split()

    def test_a_fresh_machine_gets_both_lists(self):
        code, printed, calls, installed = self.set_up()
        self.assertEqual((code, installed), (0, ["good", "sound", "extra"]), printed)
        self.assertEqual(sum(call.startswith("update") for call in calls), 1)

    def test_nothing_is_asked_where_nothing_is_missing(self):
        self.assertEqual(self.set_up(installed="good sound extra"), (0, "", [], ["good", "sound", "extra"]))

    def test_the_build_goes_on_without_drawings(self):
        code, printed, _, installed = self.set_up(offered="good sound")
        self.assertEqual((code, installed), (0, ["good", "sound"]))
        self.assertIn("SKIP: extra ", printed)
        self.assertIn("tools/setup.sh tools/apt-packages-drawings.txt tries again", printed)
        code, printed, calls, _ = self.set_up(installed="good sound", offered="good sound")
        self.assertEqual((code, calls), (0, []), "not asked twice a day")
        self.assertIn("SKIP: extra ", printed)
        code, _, _, installed = self.set_up("tools/apt-packages-drawings.txt", installed="good sound")
        self.assertEqual((code, installed), (0, ["good", "sound", "extra"]))

    def test_needed_and_named_packages_must_be_had(self):
        self.assertEqual(self.set_up(offered="good extra")[0], 1)
        self.assertEqual(self.set_up("tools/apt-packages-drawings.txt", installed="good sound", offered="good")[0], 1)


if __name__ == "__main__":
    unittest.main()
