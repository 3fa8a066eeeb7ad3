#!/usr/bin/env python3
"""Debian packages and the archive of the sources, as cpack makes them: whole, and at work away from the source tree.

GXROD_BUILD is a build folder, GXROD_SOURCE the source tree. GXROD_VENV, if set, is an environment of Python into which
`pip install` has put gxrod, as tests/campaign does.
"""

import gzip
import os
import pathlib
import re
import shutil
import subprocess
import tarfile
import unittest

from newcomer import SOURCE, VERSION, Scratch, run, without_ours

BUILD = pathlib.Path(os.environ["GXROD_BUILD"]).resolve()
VENV = os.environ.get("GXROD_VENV")
NAMES = ["gxrod", "libgxrod-dev", "python3-gxrod"]
HAS_MODULE = bool(list((BUILD / "python" / "gxrod").glob("_core*.so")))


@unittest.skipUnless(shutil.which("dpkg-shlibdeps"), "needs dpkg-dev")
class DebianPackages(Scratch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        # gzip takes a third of the time of xz, by which packages are compressed for others.
        run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", cwd=cls.folder)
        cls.packages = {path.name.split("_")[0]: path for path in cls.folder.glob("*.deb")}
        cls.root = cls.folder / "root"
        for path in cls.packages.values():
            run("dpkg-deb", "--extract", path, cls.root)

    def field(self, package, name):
        return run("dpkg-deb", "--field", self.packages[package], name).strip()

    def test_what_they_say_of_themselves(self):
        self.assertEqual(sorted(self.packages), NAMES)
        for name in NAMES:
            self.assertEqual(self.field(name, "Version"), f"{VERSION}-1")
            documents = self.root / "usr" / "share" / "doc" / name
            self.assertIn("GPL-2+", (documents / "copyright").read_text())
            self.assertIn(f"\n## {VERSION}", gzip.open(documents / "changelog.gz", "rt", encoding="utf-8").read())
            self.assertTrue(gzip.open(documents / "changelog.Debian.gz", "rt").read().startswith(f"gxrod ({VERSION}-1) "))
        self.assertIn("libhdf5", self.field("gxrod", "Depends"))
        self.assertIn("libeigen3-dev", self.field("libgxrod-dev", "Depends"))
        depends = self.field("python3-gxrod", "Depends")
        self.assertIn("python3-numpy", depends)
        self.assertEqual("libhdf5" in depends, HAS_MODULE)
        self.assertIn("python3-h5py", self.field("python3-gxrod", "Recommends"))

    def test_the_manual_names_every_verb(self):
        manual = gzip.open(self.root / "usr" / "share" / "man" / "man1" / "gxrod.1.gz", "rt").read()
        listed = run(self.root / "usr" / "bin" / "gxrod", "--help").split("Subcommands:")[1].split("Exit codes")[0]
        verbs = re.findall(r"^  (\S+)", listed, re.M)
        self.assertIn("run", verbs)
        self.assertEqual(re.findall(r"^\.TP\n\.B (\w+)$", manual, re.M), verbs)

    @unittest.skipUnless(VENV and shutil.which("lintian"), "takes a minute; only for optimised packages")
    def test_lintian_finds_no_error(self):
        # Whoever makes packages for others sets DEBEMAIL.
        known = "bogus-mail-host,bogus-mail-host-in-debian-changelog"
        found = run("lintian", "--allow-root", "--fail-on", "none", "--suppress-tags", known, *self.packages.values())
        self.assertEqual([line for line in found.splitlines() if line.startswith("E:")], [])

    def test_they_work(self):
        environment = without_ours() | {"DEBIAN_FRONTEND": "noninteractive"}
        prefix = self.root / "usr"
        if os.geteuid() == 0 and not any(run_quietly("dpkg-query", "-W", name) for name in NAMES):
            prefix = pathlib.Path("/usr")
            self.addCleanup(self.remove, environment)
            run("apt-get", "install", "-y", "-qq", "--no-install-recommends", *self.packages.values(), env=environment)
        else:
            environment["PYTHONPATH"] = str(prefix / "lib" / "python3" / "dist-packages")
        deck = prefix / "share" / "gxrod" / "examples" / "rubber_pendulum" / "rubber_pendulum.toml"
        self.work(prefix / "bin", deck, "/usr/bin/python3", HAS_MODULE, environment)

    def remove(self, environment):
        run("apt-get", "purge", "-y", "-qq", *NAMES, env=environment)
        for left in ("/usr/bin/gxrod", "/usr/share/gxrod", "/usr/lib/python3/dist-packages/gxrod", "/usr/share/doc/gxrod"):
            self.assertFalse(os.path.exists(left), left)


def run_quietly(*command):
    return subprocess.run(command, capture_output=True).returncode == 0


class Sources(Scratch):
    """The archive of the sources: everything, nothing else, and it builds without git and without a network."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("cpack", "--config", BUILD / "CPackSourceConfig.cmake", "-B", cls.folder, cwd=cls.folder)
        with tarfile.open(cls.folder / f"gxrod-{VERSION}.tar.gz") as archive:
            cls.names = {name for member in archive if not member.isdir() for name in [member.name.partition("/")[2]]}
            archive.extractall(cls.folder)
        cls.tree = cls.folder / f"gxrod-{VERSION}"

    @unittest.skipUnless(shutil.which("git") and (SOURCE / ".git").exists(), "needs git")
    def test_it_has_all_sources_and_nothing_else(self):
        listed = lambda *options: set(run("git", "-C", SOURCE, "ls-files", "-z", *options).split("\0")) - {""}
        wanted = {name for name in listed() if (SOURCE / name).exists()}
        self.assertEqual(sorted(wanted - self.names), [])
        self.assertEqual(sorted(self.names - wanted - listed("--others", "--exclude-standard")), [])

    def test_it_builds_offline(self):
        alone = ["unshare", "--net"] if os.geteuid() == 0 else ["unshare", "--net", "--map-root-user"]
        if not run_quietly(*alone, "true"):
            alone = []
        build = self.folder / "build"
        run(*alone, "cmake", "-S", self.tree, "-B", build, "-G", "Ninja", "-DGXROD_TESTS=OFF")
        self.assertIn(f'"{VERSION}"', (build / "generated" / "model" / "version.hpp").read_text())
        self.assertIn(f'"{VERSION}"', (build / "python" / "gxrod" / "_version.py").read_text())
        run(*alone, "cmake", "--build", build, "--target", "CMakeFiles/gxrod.dir/apps/gxrod/main.cpp.o")


@unittest.skipUnless(VENV, "needs GXROD_VENV")
class Wheel(Scratch):
    def test_it_works(self):
        environment = without_ours()
        deck = SOURCE / "docs" / "examples" / "rubber_pendulum" / "rubber_pendulum.toml"
        python = pathlib.Path(VENV).resolve() / "bin" / "python"
        self.work(python.parent, deck, python, True, environment)
        say = "import importlib.metadata as m, gxrod; d = m.distribution('gxrod'); print(d.version, d.metadata['License-Expression'], gxrod.program.find_program())"
        self.assertEqual(run(python, "-B", "-c", say, env=environment, cwd=self.folder).split(), [VERSION, "GPL-2.0-or-later", str(python.parent / "gxrod")])


if __name__ == "__main__":
    unittest.main()
