"""A copy of the sources in which signs and coefficients can be made wrong, built and tested."""

import copy
import json
import os
import pathlib
import re
import shutil
import subprocess

from sites import SOURCE, apply, list_files, loosen

ERROR = re.compile(r"^(?P<file>[^\s:]+):(?P<line>\d+):\d+: (?:fatal )?error:|^\s+(?:required from|from) .*?(?P<from>[^\s:]+):(?P<at>\d+)", re.M)


class Workshop:
    """The copy is folder/source, its build folder/build."""

    def __init__(self, folder, jobs):
        self.folder, self.jobs = folder, jobs
        self.copy, self.build_folder = folder / "source", folder / "build"
        self.tests = self.build_folder / "tests" / "gxrod_tests"
        self.program = self.build_folder / "gxrod"
        self.kernels = list_files()
        self.texts = {}  # of sources, as they were first read

    def set_up(self, left):
        """Copies what is under version control, but for these sources if they are there, and configures it."""
        said = subprocess.run(["git", "ls-files", "-z"], cwd=SOURCE, check=True, stdout=subprocess.PIPE).stdout
        names = {name for name in said.decode().split("\0") if name and (SOURCE / name).is_file()}
        for name in names:
            if name not in left or not (self.copy / name).exists():
                (self.copy / name).parent.mkdir(parents=True, exist_ok=True)
                content = (SOURCE / name).read_bytes()
                self.write(name, loosen(name, content.decode()).encode() if name in self.kernels else content)
        shutil.rmtree(self.folder / "aside", ignore_errors=True)
        for path in self.copy.rglob("*"):
            if path.is_file() and path.relative_to(self.copy).as_posix() not in names:
                path.unlink()
        flags = f"-O1 -w -include {self.copy}/tests/mutation/mutants.hpp"
        subprocess.run(["cmake", "-S", self.copy, "-B", self.build_folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        f"-DCMAKE_CXX_FLAGS={flags}", "-DCMAKE_CXX_FLAGS_RELEASE=", "-DGXROD_WARNINGS_AS_ERRORS=OFF",
                        "-DGXROD_JOIN_SOURCES=gxrod_test_cases"], check=True, stdout=subprocess.DEVNULL)

    def read(self, file):
        if file not in self.texts:
            self.texts[file] = (SOURCE / file).read_text()
        return self.texts[file]

    def write(self, file, content):
        path = self.copy / file
        if not path.exists() or path.read_bytes() != content:
            path.write_bytes(content)

    def write_changed(self, file, sites, how):
        self.write(file, loosen(file, apply(self.read(file), sites, how)).encode())

    def build(self, most_errors):
        """What the compiler said until there were so many errors, 0 for all; "" if it was content."""
        for targets in (["gxrod_library"], ["gxrod_tests", "gxrod"]):  # in the first are most errors
            done = subprocess.run(["cmake", "--build", self.build_folder, "--target", *targets, "--", "-k", str(most_errors), "-j",
                                   str(self.jobs)],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if done.returncode != 0:
                return done.stdout
        return ""

    def build_switches(self, sites):
        """Builds with all sites that can be switched at run time; returns them. The others are left as they were."""
        record = self.folder / "not_switched.json"  # with what earlier campaigns found
        known = {tuple(row) for row in json.loads(record.read_text())} if record.exists() else set()
        kept = [site for site in sites if site.place not in known]
        while said := self.build_with_switches(kept, {site.file for site in sites}):
            places = self.places_of(said)
            fewer = [site for site in kept if (site.file, site.line) not in places]
            if len(fewer) == len(kept):  # an error elsewhere: what comes with it is in one of these files
                named = {file for file, _ in places}
                fewer = [site for site in kept if site.file not in named]
            if len(fewer) == len(kept):
                raise RuntimeError(said[-4000:])
            print(f"  {len(kept) - len(fewer)} sites cannot be switched at run time", flush=True)
            kept = fewer
            known |= {site.place for site in sites} - {site.place for site in kept}
            record.write_text(json.dumps(sorted(known)))
        return kept

    def build_with_switches(self, sites, files):
        """What the compiler says of these files with switches at these sites."""
        for file in files:
            chosen = [site for site in sites if site.file == file]
            switch = lambda site: site.switched.replace("MUTANT", str(site.number))  # noqa: E731
            self.write_changed(file, chosen, switch)
        return self.build(most_errors=0)

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
        self.write_changed(site.file, [site], lambda it: it.replaced)
        return self.build(most_errors=1)

    def restore(self, file):
        self.write_changed(file, [], None)

    def set_aside(self, number):
        """A workshop with copies of the programs, which stay as they are while this one builds others."""
        aside = copy.copy(self)
        aside.folder = self.folder / "aside" / str(number)
        aside.folder.mkdir(parents=True, exist_ok=True)
        aside.tests = shutil.copy(self.tests, aside.folder)
        aside.program = shutil.copy(self.program, aside.folder)
        return aside

    def remove_aside(self):
        shutil.rmtree(self.folder)

    def run(self, command, mutant, seconds):
        """Exit code and output, or None if it does not end."""
        environment = {**os.environ, "GXROD_MUTANT": str(mutant)}
        try:
            done = subprocess.run(command, env=environment, timeout=seconds, cwd=self.folder, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace")
        except subprocess.TimeoutExpired:
            return None
        return done.returncode, done.stdout

    def test(self, tags, mutant, seconds):
        """"" if the tests with these tags pass, else which failed first, or how they ended."""
        done = self.run([self.tests, tags, "-a", "-r", "compact"], mutant, seconds)
        if done is None:
            return "no end"
        code, said = done
        failed = re.search(r"^(\S*?tests/\S+?):\d+: failed", said, re.M)
        return "" if code == 0 else re.sub(r".*tests/", "tests/", failed[1]) if failed else f"ended with code {code}"

    def verify(self, mutant, seconds):
        """"" if the validation book's values are found, else what is missed first."""
        done = self.run([self.program, "verify", "--all"], mutant, seconds)
        if done is None:
            return "no end"
        code, said = done
        missed = re.search(r"^(\w+) \(.*\n(?:  .*\n)*?  .*MISSED", said, re.M)
        return "" if code == 0 else f"gxrod verify {missed[1]}" if missed else f"gxrod verify ended with code {code}"
