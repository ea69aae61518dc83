# SPDX-License-Identifier: MIT
"""What `gnomon-study report` says to bad input, and what it leaves behind: bad_input_test.py PROGRAM"""
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import unittest

import fixture

PROGRAM = sys.argv.pop(1)


class BadInput(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.out = self.folder / "out"

    def few(self):
        """A file with few rows, which is drawn fast."""
        fixture.write(self.folder / "study")
        results = self.folder / "study" / "results.jsonl"
        lines = [line for line in results.read_text().splitlines(keepends=True) if json.loads(line)["group"].startswith("room")]
        results.write_text("".join(lines))
        return results, lines

    def report(self, results, out=None, **options):
        return subprocess.run([PROGRAM, "report", str(results), "--out", str(out or self.out)], capture_output=True, text=True, **options)

    def refused(self, done, code, *words):
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("gnomon-study: "), done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        left = [path.name for path in self.out.glob("*")] if self.out.is_dir() else []
        self.assertEqual([name for name in left if not name.endswith(".png")], [])

    def test_no_file(self):
        self.refused(self.report(self.folder / "none.jsonl"), 2, "none.jsonl", "No such file")

    def test_folder_for_a_file(self):
        self.refused(self.report(self.folder), 2, "folder")

    def test_empty(self):
        (self.folder / "empty.jsonl").touch()
        self.refused(self.report(self.folder / "empty.jsonl"), 2, "empty")

    def test_no_row_in_it(self):
        (self.folder / "other.jsonl").write_text('{"kind": "else"}\n')
        self.refused(self.report(self.folder / "other.jsonl"), 2, "no row")

    def test_broken_last_line(self):
        results, lines = self.few()
        results.write_text("".join(lines) + lines[0][:200])
        done = self.report(results)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"line {len(lines) + 1}: broken off", done.stderr)
        self.assertIn(f"{len(lines)} rows", done.stdout)
        self.assertIn(f"line {len(lines) + 1}: broken off", (self.out / "index.html").read_text())

    def test_strange_rows_are_told_and_left_out(self):
        results, lines = self.few()
        good = json.loads(lines[0])
        without = {key: value for key, value in good.items() if key != "total_ms"} | {"job": "a"}
        strange = [json.dumps(without), json.dumps(good | {"job": "b", "schema": 2}), json.dumps(good | {"job": "c", "technique": 3}), "[1",
                   json.dumps(good | {"job": "d", "total_ms": [-1.0]})]
        results.write_text("\n".join(strange) + "\n" + "".join(lines))
        done = self.report(results)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = done.stderr.splitlines()
        self.assertEqual(len(told), len(strange), done.stderr)
        for words, line in zip(("total_ms", "schema is not 1", "must be string", "not JSON", "a time that is none"), told):
            self.assertIn(words, line)
        self.assertIn(f"{len(lines)} rows", done.stdout)

    def test_hostile_words_stay_text(self):
        results, lines = self.few()
        results.write_text(lines[0] + json.dumps(json.loads(lines[1]) | {"technique": "<script>alert(1)</script>", "name": "../a & b"}) + "\n")
        done = self.report(results)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("<script>alert", (self.out / "index.html").read_text())
        self.assertEqual({path.parent for path in self.out.glob("**/*")}, {self.out})

    def test_picture_that_is_gone(self):
        results, lines = self.few()
        (results.parent / "pictures" / "truth.png").unlink()
        done = self.report(results)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("cannot read its picture 'pictures/truth.png'", done.stderr)

    def test_file_in_the_way_of_the_folder(self):
        results, lines = self.few()
        (self.folder / "file").touch()
        self.refused(self.report(results, self.folder / "file"), 2, "cannot make the folder")

    def test_full_disk(self):
        results, lines = self.few()
        done = self.report(results, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (40000, 40000)),
                           env=os.environ | {"LP_NUM_THREADS": "1"})
        self.refused(done, 2, "cannot write")

    def test_no_display(self):
        results, lines = self.few()
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"} | {"PATH": "/nowhere"}
        self.refused(self.report(results, env=environment), 2, "no display", "xvfb")

    def test_display_that_does_not_answer(self):
        results, lines = self.few()
        done = self.report(results, env=os.environ | {"DISPLAY": ":987"})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertGreater((self.out / "overview.png").stat().st_size, 10000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
