#!/usr/bin/env python3
"""A second decoder of streams, written from section 8 of PROTOCOL.md alone.

It shares no code with the implementation and needs nothing but Python 3. Each line of `streams.json` holds a
subscription, the frames of it that came through, and the samples that a host has to make of them.

    python3 streams.py ../../vectors
"""

import json
import sys
from pathlib import Path

from decode import frame


class Gap(Exception):
    """What the frame differs from is not there, or it does not decode."""


def widths(subject):
    """Bits of each value of a sample, and whether extremes are among them."""
    (kind, what), = subject.items()
    if kind == "Mechanisms":
        return [1, 16, 16, 32] * len(what), False
    if kind == "Trace":
        return [1, 1, 1, 64 if what["wide"] else 32] * len(what["pcs"]), False
    if kind == "Lines":
        register = {"Dr32": 32, "Dr64": 64, "Real": 64}
        return [bits for line in what for bits in [1, 1, 1, register[line["register"]]]], False
    bits, extremes = [], False
    for item in what:
        form = item["kind"]
        if form == "Real":
            own = 64
        else:
            (name, number), = form.items()
            own = 1 if name == "Bit" else number * 8
        more = {"Value": [], "OnChange": [], "Extremes": [own, own], "Edges": [16, 16]}[item["mode"]]
        bits += [own] + more
        extremes |= item["mode"] == "Extremes"
    return bits, extremes


class Bits:
    """Bits of bytes, the highest of each first."""

    def __init__(self, data):
        self.text = "".join(f"{byte:08b}" for byte in data)

    def take(self, count):
        if count > len(self.text):
            raise Gap("too short")
        value, self.text = self.text[:count], self.text[count:]
        return int(value, 2) if count else 0

    def golomb(self, order):
        zeros = 0
        while self.take(1) == 0:
            zeros += 1
        return (1 << (zeros + order) | self.take(zeros + order)) - (1 << order)

    def difference(self, width):
        count = self.take({8: 1, 16: 2, 32: 3, 64: 4}[width]) + 1
        folded = self.take(4 * count)
        return folded >> 1 if folded % 2 == 0 else -(folded >> 1) - 1

    def is_done(self):
        return len(self.text) < 8 and "1" not in self.text


def varint(data):
    value = 0
    for at, byte in enumerate(data[:5]):
        value |= (byte & 0x7F) << 7 * at
        if byte < 0x80:
            return value, data[at + 1:]
    raise Gap("varint")


class Stream:
    """The host's side of one stream."""

    def __init__(self, subscription):
        self.id = subscription["id"]
        self.widths, self.extremes = widths(subscription["subject"])
        self.last = self.whole = None  # (number, values)
        self.distance = 0

    def take(self, seq, payload):
        """A sample, or None for a frame that was late."""
        head, rest = payload[0], payload[1:]
        assert head >> 5 == self.id
        form, low = head >> 3 & 3, (head & 3) << 8 | seq
        distance = self.distance
        if head & 4:
            number, rest = varint(rest)
            cycle, rest = varint(rest)
            distance = number - cycle
            if number % 1024 != low:
                raise Gap("number")
        elif self.last is None:
            raise Gap("nothing known")
        else:
            ahead = (low - self.last[0]) % 1024
            if ahead == 0 or ahead > 512:
                return None
            number = (self.last[0] + ahead) % 2**32
        if self.last is not None:
            newer = (number - self.last[0]) % 2**32
            if newer >= 2**31 or newer == 0 and form > 1:
                return None
        bits = Bits(rest)
        window = bits.golomb(0) if self.extremes else 0
        values = self.values(form, number, bits)
        if not bits.is_done():
            raise Gap("more than there should be")
        contiguous = self.last is None or (number - window) % 2**32 == self.last[0]
        self.distance, self.last = distance, (number, values)
        if form < 2:
            self.whole = self.last
        return {"number": number, "cycle": (number - distance) % 2**32, "values": values, "window": window,
                "contiguous": contiguous}

    def values(self, form, number, bits):
        if form == 0:
            return [bits.take(width) for width in self.widths]
        if form == 1:
            return [bits.take(1) if width == 1 else bits.difference(width) % 2**width for width in self.widths]
        base, order = (self.whole, 6) if form == 2 else (self.last, 0)
        if base is None or (number - base[0]) % 2**32 != bits.golomb(order) + 1:
            raise Gap("what it differs from")
        values, at = list(base[1]), -1
        order = (len(values).bit_length() - 1) // 2
        while not bits.is_done():
            at += bits.golomb(order) + 1
            if at >= len(values):
                raise Gap("past the end")
            width = self.widths[at]
            values[at] = (values[at] + (1 if width == 1 else bits.difference(width))) % 2**width
        return values


def main():
    vectors = json.loads((Path(sys.argv[1]) / "streams.json").read_text())
    count = 0
    for vector in vectors:
        stream, samples = Stream(vector["subscription"]), []
        for text in vector["frames"]:
            kind, seq, payload = frame(bytes.fromhex(text)[:-1])
            assert kind == 0x85
            try:
                sample = stream.take(seq, payload)
                samples += [] if sample is None else [sample]
            except Gap:
                pass  # the host says that its values are stale, and asks
        for ours, theirs in zip(samples, vector["samples"]):
            assert ours == theirs, f"{vector['name']}: {ours} is not {theirs}"
        assert len(samples) == len(vector["samples"]), vector["name"]
        count += len(samples)
    print(count, "samples agree")


if __name__ == "__main__":
    main()
