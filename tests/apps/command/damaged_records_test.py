"""Records that are damaged, edited, packed anew: damaged_records_test.py SWIRL [COUNT]

Each of COUNT damaged copies (6 unless given) goes to every reader: exit 2 and one line, whatever was damaged; and once
more without its checksum, where an answer is allowed, but neither a crash nor a hang."""

import os
import random
import sys
import time
import unittest

import h5py

from driving import InFolder, document, run

COUNT = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 6
HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
SWEEP = "sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.2:0.8:3 --transient 100 --collisions 64"
TRAILER = 89


def damaged(content, generator):
    """A copy with one kind of damage, never the same bytes."""
    while True:
        data = bytearray(content)
        kind = generator.randrange(5)
        place = generator.randrange(len(data))
        if kind == 0:  # single bytes
            for _ in range(generator.choice((1, 1, 2, 8, 64))):
                data[generator.randrange(len(data))] = generator.randrange(256)
        elif kind == 1:  # cut short
            del data[place:]
        elif kind == 2:  # two blocks change places
            size = generator.choice((8, 64, 512, 4096))
            other = generator.randrange(len(data))
            a, b = sorted((place, other))
            size = min(size, b - a, len(data) - b)
            data[a:a + size], data[b:b + size] = data[b:b + size], data[a:a + size]
        elif kind == 3:  # a block of zeros, or of ones
            size = generator.choice((8, 64, 512, 4096))
            end = min(len(data), place + size)
            data[place:end] = bytes([generator.choice((0, 255))]) * (end - place)
        else:  # bytes that are missing, or too many
            if generator.random() < 0.5:
                del data[place:place + generator.choice((1, 8, 512))]
            else:
                data[place:place] = generator.randbytes(generator.choice((1, 8, 512)))
        if data != content:
            return bytes(data)


class Damaged(InFolder):
    def setUp(self):
        super().setUp()
        self.orbit, self.sweep = (self.folder / f"{name}.h5" for name in ("orbit", "sweep"))
        for command in (f"simulate {HEXAGON} --collisions 300 -o {self.orbit}", f"{SWEEP} -o {self.sweep}"):
            self.assertEqual(run(f"{command} --quiet").returncode, 0)
        self.bad = self.folder / "bad.h5"
        self.before = {path.name for path in self.folder.iterdir()}

    def readers(self, of):
        figure = self.folder / "bad.svg"
        if of == self.sweep:
            return [f"{SWEEP} -o {self.bad}", f"plot {self.bad} -o {figure}"]
        return [f"recurrence {self.bad} --threshold 0.1", f"spectrum {self.bad}",
                f"classify {self.bad} --transient 100 --collisions 100", f"plot {self.bad} -o {figure}",
                f"recurrence {self.orbit} --cross {self.bad} --threshold 0.1"]

    def test_a_damaged_record_is_refused_in_one_line_by_every_reader(self):
        generator = random.Random(20261122)
        for number in range(COUNT):
            of = (self.orbit, self.orbit, self.sweep)[number % 3]
            content = damaged(of.read_bytes(), generator)
            self.bad.write_bytes(content)
            for command in self.readers(of):
                result = run(command)
                self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1),
                                 (number, command, result.stderr))
                self.assertIn("bad.h5", result.stderr)
            self.assertEqual(self.bad.read_bytes(), content)
            self.assertEqual({path.name for path in self.folder.iterdir()}, self.before | {"bad.h5"})

    def test_without_a_checksum_it_neither_crashes_nor_hangs(self):
        generator = random.Random(20261123)
        answered = refused = 0
        for number in range(COUNT):
            of = (self.orbit, self.orbit, self.sweep)[number % 3]
            self.bad.write_bytes(damaged(of.read_bytes()[:-TRAILER], generator))
            readers = self.readers(of)
            for command in readers if COUNT > 100 else readers[number % len(readers):][:2]:
                begin = time.monotonic()
                result = run(command)
                self.assertLess(time.monotonic() - begin, 60, (number, command))
                self.assertIn(result.returncode, (0, 2, 3), (number, command, result.stderr))
                self.assertNotIn("Traceback", result.stderr)
                # The warning and the error; or the warning, that the sweep is whole, and its seconds.
                self.assertLessEqual(len(result.stderr.splitlines()), 3 if result.returncode == 0 else 2, result.stderr)
                answered += result.returncode == 0
                refused += result.returncode == 2
            (self.folder / "bad.svg").unlink(missing_ok=True)
        print(f"{COUNT} damaged records without a checksum: {answered} answers, {refused} refusals")
        self.assertGreater(refused, 0)

    def test_damage_to_the_checksum_itself_is_damage(self):
        content = self.orbit.read_bytes()
        for place in range(-TRAILER, 0, 8):
            data = bytearray(content)
            data[place] ^= 0x21
            self.bad.write_bytes(data)
            result = run(f"spectrum {self.bad}")
            self.assertEqual((result.returncode, result.stdout), (2, ""), place)
            self.assertIn("damaged", result.stderr)


class CutShort(InFolder):
    def test_it_is_said_that_a_record_may_be_cut_short(self):
        path = self.folder / "a.h5"
        run(f"simulate {HEXAGON} --collisions 20 --quiet -o {path}")
        path.write_bytes(path.read_bytes()[:-TRAILER - 8])
        result = run(f"show {path}")
        self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1))
        self.assertIn("it is damaged: it was cut short, or changed after it was written; make it anew", result.stderr)


class Edited(InFolder):
    """What no checksum speaks for is read with one word of warning."""

    def setUp(self):
        super().setUp()
        self.record = self.folder / "orbit.h5"
        self.assertEqual(run(f"simulate {HEXAGON} --collisions 300 --quiet -o {self.record}").returncode, 0)

    def check_warning(self, path, *others):
        right = document(f"spectrum {self.record}")
        for command in (f"spectrum {path}", f"recurrence {path} --threshold 0.1",
                        f"classify {path} --transient 100 --collisions 100", *others):
            result = run(command)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stderr.count("has no checksum"), 1, (command, result.stderr))
            self.assertNotIn("checksum", run(f"{command} --quiet").stderr)
        self.assertEqual(document(f"spectrum {path} --quiet"), right)

    def test_a_fresh_record_is_read_without_a_word(self):
        self.assertEqual(run(f"spectrum {self.record} --json").stderr, "")
        self.assertEqual(run(f"plot {self.record} -o {self.folder}/a.svg").stderr, "")
        with h5py.File(self.record) as file:
            self.assertEqual(file.userblock_size, 0)
        self.assertTrue(self.record.read_bytes()[-TRAILER:].startswith(b"swirl record\ncrc-64/xz "))

    def test_an_edited_one(self):
        with h5py.File(self.record, "r+") as file:
            file.attrs["note"] = "looked at twice"
            file.create_dataset("mine", data=list(range(2000)))
        with_note = self.folder / "edited.h5"
        self.record.rename(with_note)
        self.assertEqual(run(f"simulate {HEXAGON} --collisions 300 --quiet -o {self.record}").returncode, 0)
        self.check_warning(with_note, f"plot {with_note} -o {self.folder}/a.svg")

    def test_one_that_was_copied_object_by_object(self):
        packed = self.folder / "packed.h5"
        with h5py.File(self.record) as old, h5py.File(packed, "w") as new:
            new.attrs.update(old.attrs)
            for name in old:
                old.copy(name, new)
        self.check_warning(packed)  # h5py's copy does not carry the references that plot follows

    def test_one_that_says_of_itself_what_is_not_so_is_not_classified(self):
        kept = self.record.read_bytes()
        for group, name, value in (("settings", "every", 0), ("settings", "every", 7), ("settings", "skip", -1),
                                   ("settings", "skip", 300), ("result", "impacts", 2**62), ("result", "impacts", -2**63)):
            self.record.write_bytes(kept)
            with h5py.File(self.record, "r+") as file:
                file[group].attrs.modify(name, value)
            result = run(f"classify {self.record}")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1),
                             (name, value, result.stderr))
            self.assertIn("skip = -1" if value == -1 else "is not whole", result.stderr)

    def test_one_whose_numbers_were_changed_in_place_is_refused_until_the_checksum_is_taken_away(self):
        trailer = self.record.read_bytes()[-TRAILER:].splitlines()
        with h5py.File(self.record, "r+") as file:
            file["result"].attrs.modify("mean_S", 0.5)
        length = self.record.stat().st_size
        with self.record.open("ab") as file:
            file.write(b"\n".join([*trailer[:2], b"bytes: %020d" % (length + TRAILER), b""]))
        refused = run(f"spectrum {self.record}")
        self.assertEqual((refused.returncode, len(refused.stderr.splitlines())), (2, 1))
        self.assertIn("cut off the last 89 bytes", refused.stderr)
        os.truncate(self.record, length)
        read = run(f"spectrum {self.record}")
        self.assertEqual((read.returncode, read.stderr.count("has no checksum")), (0, 1), read.stderr)


if __name__ == "__main__":
    unittest.main()
