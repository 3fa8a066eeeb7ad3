"""VTK and h5py open results while a job writes them, and after it was killed."""

import json
import signal
import subprocess
import sys
import time
import unittest

import h5py
import numpy as np
from program import GXROD, SOURCE, ProgramTest
from reading import frame_at, open_file, points_of, times_of

LOOK = """
import json, sys
from reading import frame_at, open_file, points_of, times_of
reader = open_file(sys.argv[1])
times = times_of(reader)
points = points_of(frame_at(reader, times[-1]))
print(json.dumps({"times": times.tolist(), "points": points.tolist()}))
"""


class RunningJob(ProgramTest):
    def start_job(self):
        """A job of some ten seconds with a frame a hundred steps; gives it when there are frames."""
        deck = SOURCE / "docs/examples/free_flight/free_flight.toml"
        self.results = self.folder / "free_flight.vtkhdf"
        self.results.unlink(missing_ok=True)
        job = subprocess.Popen([GXROD, "run", deck, "--quiet", "--set", "analysis.end_time=1000",
                                "--set", "output.every=100"], cwd=self.folder)
        self.addCleanup(job.wait)
        self.addCleanup(job.kill)
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and self.count_frames() < 2:
            time.sleep(0.05)
        self.assertIsNone(job.poll())
        return job

    def count_frames(self):
        try:
            with h5py.File(self.results) as file:
                return len(file["VTKHDF/Steps/Values"])
        except (OSError, RuntimeError, KeyError):
            return 0

    def look(self):
        """What VTK shows of the last frame, in a process of its own: at the moment of writing VTK may crash."""
        for _ in range(10):
            done = subprocess.run([sys.executable, "-c", LOOK, self.results], env={"PYTHONPATH": ":".join(sys.path)},
                                  capture_output=True, text=True, timeout=60, check=False)
            if done.returncode == 0:
                shown = json.loads(done.stdout)
                if shown["points"] and np.all(np.diff(shown["times"]) > 0):
                    return np.array(shown["times"]), np.array(shown["points"])
        self.fail(f"VTK shows nothing: {done.stderr}")

    def test_steps_so_far(self):
        job = self.start_job()
        looks = []
        for _ in range(4):
            looks.append(self.look())
            time.sleep(0.3)
        self.assertIsNone(job.poll(), "the job ended before it was looked at")
        job.send_signal(signal.SIGINT)
        job.wait(60)
        self.assertGreater(len(looks[-1][0]), len(looks[0][0]))
        with h5py.File(self.results) as file:
            grid = file["VTKHDF"]
            count = grid["NumberOfPoints"][0]
            for times, points in looks:
                last = len(times) - 1
                np.testing.assert_array_equal(times, grid["Steps/Values"][:last + 1])
                np.testing.assert_array_equal(points, grid["Points"][last * count:(last + 1) * count])

    def test_what_a_killed_job_leaves_and_resumes(self):
        for _ in range(5):
            job = self.start_job()
            time.sleep(0.1)
            job.kill()
            job.wait(60)
            times = self.assert_every_frame_is_shown("running")
            self.gxrod("export", "free_flight.vtkhdf", "--series", "series", "--force")
        self.gxrod("resume", "free_flight.vtkhdf", "--quiet", "--set", f"analysis.end_time={times[-1] + 5}")
        resumed = self.assert_every_frame_is_shown("complete")
        self.assertGreater(len(resumed), len(times))

    def assert_every_frame_is_shown(self, status):
        """Gives their times."""
        with h5py.File(self.results) as file:
            grid = file["VTKHDF"]
            self.assertEqual(file.attrs["status"], status)
            times, count = grid["Steps/Values"][()], grid["NumberOfPoints"][0]
            self.assertLessEqual(len(times), grid["Steps"].attrs["NSteps"])
            reader = open_file(self.results)
            np.testing.assert_array_equal(times_of(reader)[:len(times)], times)
            for number, time_of_frame in enumerate(times):
                np.testing.assert_array_equal(points_of(frame_at(reader, time_of_frame)),
                                              grid["Points"][number * count:(number + 1) * count])
            return times


if __name__ == "__main__":
    unittest.main()
