"""The program `peers` (peers.cpp), one process that answers lines."""

import subprocess

from container_frame import Impact


def read_impact(words):
    return Impact(words[0] == "1", float(words[1]), int(words[2]), tuple(float(word) for word in words[3:10]))


class CompiledPeers:
    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()

    def _ask(self, question, lines):
        self.process.stdin.write(question + "\n")
        self.process.stdin.flush()
        answers = [self.process.stdout.readline() for _ in range(lines)]
        if "" in answers:
            raise RuntimeError(f"no answer to: {question}")
        return [answer.split() for answer in answers]

    def draw(self, scene, seed, count):
        """Starts and, in quad, the impacts that follow them."""
        answers = self._ask(f"scene {scene} {seed} {count}", count)
        return [tuple(float(word) for word in words[:7]) for words in answers], [read_impact(w[7:]) for w in answers]

    def next(self, peer, tolerance, step, count):
        return [read_impact(words) for words in self._ask(f"next {peer} {tolerance} {step} {count}", count)]

    def row(self, peer, tolerance, step, first, count):
        """Up to `count` impacts in a row from start `first`; fewer where one is not found."""
        impacts = [read_impact(self._ask(f"row {peer} {tolerance} {step} {first} {count}", 1)[0])]
        while impacts[-1].found and len(impacts) < count:
            impacts.append(read_impact(self.process.stdout.readline().split()))
        return [impact for impact in impacts if impact.found]

    def seconds_per_impact(self, peer, tolerance, step, first, count, seconds):
        return float(self._ask(f"follow {peer} {tolerance} {step} {first} {count} {seconds}", 1)[0][0])

    def numbers(self):
        return " ".join(self._ask("numbers", 1)[0])
