"""A copy of the sources in which signs and coefficients can be made wrong, built and tested."""

import os
import pathlib
import re
import shutil
import subprocess

from sites import apply

SOURCE = pathlib.Path(__file__).resolve().parents[2]
ERROR = re.compile(r"^(?P<file>[^\s:]+):(?P<line>\d+):\d+: (?:fatal )?error:|^\s+(?:required from|from) .*?(?P<from>[^\s:]+):(?P<at>\d+)", re.M)


class Workshop:
    """The copy is folder/source, its build folder/build."""

    def __init__(self, folder, jobs):
        self.folder, self.jobs = folder, jobs
        self.copy, self.build_folder = folder / "source", folder / "build"
        self.tests = self.build_folder / "tests" / "gxrod_tests"

    def set_up(self):
        """Copies what is under version control and configures it."""
        shutil.rmtree(self.copy, ignore_errors=True)
        names = subprocess.run(["git", "ls-files", "-z"], cwd=SOURCE, check=True, stdout=subprocess.PIPE).stdout
        for name in names.decode().split("\0"):
            if name and (SOURCE / name).is_file():
                (self.copy / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(SOURCE / name, self.copy / name)
        flags = f"-O1 -include {self.copy}/tests/mutation/mutants.hpp"
        subprocess.run(["cmake", "-S", self.copy, "-B", self.build_folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        f"-DCMAKE_CXX_FLAGS={flags}", "-DCMAKE_CXX_FLAGS_RELEASE=", "-DGXROD_WARNINGS_AS_ERRORS=OFF"],
                       check=True, stdout=subprocess.DEVNULL)

    def read(self, file):
        return (SOURCE / file).read_text()

    def write(self, file, text):
        path = self.copy / file
        if path.read_text() != text:
            path.write_text(text)

    def build(self, target="gxrod_tests"):
        """What the compiler said, "" if it was content."""
        done = subprocess.run(["cmake", "--build", self.build_folder, "--target", target, "--", "-k", "0", "-j", str(self.jobs)],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return "" if done.returncode == 0 else done.stdout

    def build_switches(self, sites):
        """Builds with all sites that can be switched at run time; returns them. The others are left as they were."""
        kept = list(sites)
        while True:
            by_file = {}
            for site in kept:
                by_file.setdefault(site.file, []).append(site)
            for file in {site.file for site in sites}:
                chosen = by_file.get(file, [])
                switch = lambda site: site.switched.replace("MUTANT", str(site.number))
                self.write(file, apply(self.read(file), chosen, switch))
            said = self.build()
            if not said:
                return kept
            places = self.places_of(said)
            fewer = [site for site in kept if (site.file, site.line) not in places]
            if len(fewer) == len(kept):  # an error elsewhere: what comes with it is in one of these files
                named = {file for file, _ in places}
                fewer = [site for site in kept if site.file not in named]
            if len(fewer) == len(kept):
                raise RuntimeError(said[-4000:])
            print(f"  {len(kept) - len(fewer)} sites cannot be switched at run time", flush=True)
            kept = fewer

    def places_of(self, said):
        """The lines that the compiler names, whether it blames them or comes from them."""
        places = set()
        for match in ERROR.finditer(said):
            file, line = (match["file"], match["line"]) if match["file"] else (match["from"], match["at"])
            path = pathlib.Path(file)
            path = (path if path.is_absolute() else self.build_folder / path).resolve()
            if path.is_relative_to(self.copy.resolve()):
                places.add((path.relative_to(self.copy.resolve()).as_posix(), int(line)))
        return places

    def replace(self, site):
        """Makes one site wrong for good; returns what the compiler said."""
        self.write(site.file, apply(self.read(site.file), [site], lambda it: it.replaced))
        return self.build()

    def restore(self, file):
        self.write(file, self.read(file))

    def test(self, filters, mutant, seconds):
        """"" if the tests pass, else which test failed first, or how they ended."""
        environment = {**os.environ, "GXROD_MUTANT": str(mutant)}
        try:
            done = subprocess.run([self.tests, *filters, "-a", "-r", "compact"], env=environment, timeout=seconds,
                                  cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        except subprocess.TimeoutExpired:
            return "no end"
        if done.returncode == 0:
            return ""
        failed = re.search(r"^(\S+?/tests/\S+?):\d+: failed", done.stdout, re.M)
        if failed:
            return re.sub(r".*/tests/", "tests/", failed[1])
        return f"ended with code {done.returncode}"
