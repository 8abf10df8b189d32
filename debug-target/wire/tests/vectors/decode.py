#!/usr/bin/env python3
"""A second decoder of the TECHNOL debug protocol, written from PROTOCOL.md alone.

It shares no code with the implementation and needs nothing but Python 3. Given the folder of the test vectors it
reads every frame and message in them and compares what it understood with what the vectors say.

    python3 decode.py ../../vectors
"""

import json
import struct
import sys
from pathlib import Path


def crc32c(data):
    """CRC-32C (Castagnoli), bit by bit."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


class Damaged(Exception):
    """The bytes are no frame; the text says why."""


def unstuff(data):
    """Undoes COBS."""
    out = bytearray()
    at = 0
    while at < len(data):
        code = data[at]
        block = data[at + 1:at + code]
        if code == 0 or len(block) != code - 1:
            raise Damaged("stuffing")
        out += block
        at += code
        if code != 0xFF and at < len(data):
            out.append(0)
    return bytes(out)


def frame(data):
    """Kind, number and payload of what stood between two zeros."""
    content = unstuff(data)
    if len(content) < 6:
        raise Damaged("short")
    body, crc = content[:-4], struct.unpack("<I", content[-4:])[0]
    if crc32c(body) != crc:
        raise Damaged("checksum")
    return body[0], body[1], body[2:]


class Reader:
    """Takes values off the front of bytes, as postcard writes them."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def take(self, count):
        piece = self.data[self.at:self.at + count]
        if len(piece) != count:
            raise ValueError("the message is too short")
        self.at += count
        return piece

    def u8(self):
        return self.take(1)[0]

    def flag(self):
        return {0: False, 1: True}[self.u8()]

    def uint(self):
        value, shift = 0, 0
        while True:
            byte = self.u8()
            value |= (byte & 0x7F) << shift
            if byte < 0x80:
                return value
            shift += 7

    def int(self):
        raw = self.uint()
        return raw >> 1 ^ -(raw & 1)

    def f64(self):
        return struct.unpack("<d", self.take(8))[0]

    def text(self):
        return self.take(self.uint()).decode("utf-8")

    def octets(self):
        return list(self.take(self.uint()))


U8, UINT, INT, FLAG, F64 = Reader.u8, Reader.uint, Reader.int, Reader.flag, Reader.f64
TEXT, OCTETS = Reader.text, Reader.octets


def optional(inner):
    return lambda r: inner(r) if r.flag() else None


def many(inner):
    return lambda r: [inner(r) for _ in range(r.uint())]


def pair(first, second):
    return lambda r: [first(r), second(r)]


def fields(**members):
    return lambda r: {name: read(r) for name, read in members.items()}


def variants(*table):
    """Names of variants, each with what follows it (None: nothing)."""

    def read(r):
        number = r.uint()
        name, content = table[number]
        return name if content is None else {name: content(r)}

    return read


def words(text):
    return variants(*[(word, None) for word in text.split()])


def HASH(r):
    return list(r.take(16))


LIMITS = fields(max_payload=UINT, max_read=UINT, max_breakpoints=UINT, window=U8)
PLC_STATE = words("Empty Stopped Starting Running Stopping Halted Faulted")
STATUS = fields(plc=PLC_STATE, held=FLAG, cycle=UINT, program=optional(HASH))
REGISTERS = fields(rlo=FLAG, dr=INT, dr_real=F64, bx=UINT, stack=U8, depth=U8)
CALL = fields(pc=UINT, procedure=optional(UINT), sequence=optional(UINT), module=U8)
SEQUENCE = fields(sequence=UINT, active=FLAG, resume=UINT, line=UINT, since=UINT)
BREAKPOINT = words("Set NotAStatement InFast InCont TooMany")
RESUME = variants(
    ("Continue", None), ("Into", None), ("Over", fields(sequence=optional(UINT))), ("Out", None))
FILE_REQUEST = variants(
    ("List", fields(path=TEXT, **{"from": UINT})),
    ("Read", fields(path=TEXT, offset=UINT, len=UINT)),
    ("Sum", fields(path=TEXT)),
    ("Store", fields(path=TEXT)),
    ("Copy", fields(**{"from": TEXT, "to": TEXT})),
    ("Move", fields(**{"from": TEXT, "to": TEXT})),
    ("Delete", fields(path=TEXT)),
    ("MakeFolder", fields(path=TEXT)),
)
ENTRY = fields(name=TEXT, folder=FLAG, size=UINT, modified=UINT)
FILE_ANSWER = variants(
    ("Entries", fields(entries=many(ENTRY), more=FLAG)),
    ("Bytes", fields(bytes=OCTETS, size=UINT)),
    ("Sum", fields(size=UINT, hash=HASH)),
)
ITEM_KIND = variants(("Bit", U8), ("Unsigned", U8), ("Signed", U8), ("Real", None))
ITEM = fields(addr=UINT, kind=ITEM_KIND, mode=words("Value OnChange Extremes Edges"))
TRACED_LINE = fields(pc=UINT, register=words("Dr32 Dr64 Real"))
SUBJECT = variants(
    ("Variables", many(ITEM)), ("Mechanisms", many(UINT)), ("Trace", fields(pcs=many(UINT), wide=FLAG)),
    ("Lines", many(TRACED_LINE)))
REQUEST = variants(
    ("Hello", fields(version=UINT, session=UINT)),
    ("Status", None),
    ("Download", fields(len=UINT, hash=HASH)),
    ("Commit", None),
    ("Start", fields(cold=FLAG, stop_on_entry=FLAG)),
    ("Stop", None),
    ("Clear", None),
    ("SetBreakpoints", fields(pcs=many(UINT))),
    ("Resume", RESUME),
    ("Pause", None),
    ("Registers", None),
    ("SetRegisters", REGISTERS),
    ("Read", fields(pieces=many(pair(UINT, UINT)))),
    ("Write", fields(addr=UINT, bytes=OCTETS)),
    ("WriteBits", fields(addr=UINT, mask=U8, value=U8)),
    ("CallStack", None),
    ("Sequences", None),
    ("SetSequence", fields(sequence=UINT, active=FLAG)),
    ("SetFault", fields(name=TEXT, on=FLAG)),
    ("Press", fields(key=TEXT, down=FLAG)),
    ("Goodbye", fields(stop=FLAG)),
    ("Subscribe", fields(id=U8, period=UINT, subject=SUBJECT)),
    ("Unsubscribe", fields(id=U8)),
    ("OnLinkLost", words("RunOn StayStopped StopPlc")),
    ("Echo", fields(bytes=OCTETS)),
    ("Files", FILE_REQUEST),
    ("MachineRegisters", None),
)
FAILURE = variants(
    ("Unsupported", None), ("Malformed", None), ("Version", None), ("NoSession", None), ("NoProgram", None),
    ("NotStopped", None), ("NotRunning", None), ("OutOfRange", None), ("Incomplete", None),
    ("BadProgram", TEXT), ("NotFound", TEXT), ("TooLarge", None), ("Refused", TEXT))
RESPONSE = variants(
    ("Done", None),
    ("Hello", fields(version=UINT, limits=LIMITS, boot=UINT, status=STATUS, features=UINT)),
    ("Status", STATUS),
    ("Breakpoints", many(BREAKPOINT)),
    ("Registers", REGISTERS),
    ("Memory", fields(cycle=UINT, bytes=OCTETS)),
    ("CallStack", many(CALL)),
    ("Sequences", many(SEQUENCE)),
    ("Failed", FAILURE),
    ("Echo", fields(bytes=OCTETS, damaged=UINT)),
    ("Files", FILE_ANSWER),
    ("MachineRegisters", fields(eax=UINT, flags=UINT)),
)
STOPPED = fields(
    reason=words("Breakpoint Step Pause Entry Fault"), pc=UINT, module=U8, sequence=optional(UINT), cycle=UINT,
    registers=REGISTERS, frames=many(CALL))
FAULT = fields(
    kind=words("DivisionByZero QuotientOverflow BcdRange StackOverflow StackUnderflow BadAddress EndlessLoop "
               "CallDepth UnexpectedReturn UnexpectedEnd BadContinuation NoService"),
    pc=UINT, module=U8, sequence=optional(UINT), cycle=UINT)
EVENT = variants(
    ("Stopped", STOPPED),
    ("Resumed", None),
    ("State", STATUS),
    ("Fault", FAULT),
    ("Message", fields(cycle=UINT, number=UINT, sub_id=optional(INT), set=FLAG, parameters=many(INT), pc=UINT)),
    ("Overrun", fields(cycle=UINT, fast=FLAG)),
    ("Log", TEXT),
)
CHUNK = fields(offset=UINT, bytes=OCTETS)
CHUNK_ACK = fields(complete=UINT, islands=many(pair(UINT, UINT)))

MESSAGES = {"Request": REQUEST, "Response": RESPONSE, "Event": EVENT, "Chunk": CHUNK, "ChunkAck": CHUNK_ACK}

# Name, and what the payload holds; True: in parts.
KINDS = {
    0x01: ("request", REQUEST, True), 0x02: ("event ack", None, False), 0x03: ("chunk", CHUNK, False),
    0x04: ("ping", None, False), 0x81: ("response", RESPONSE, True), 0x82: ("event", EVENT, True),
    0x83: ("chunk ack", CHUNK_ACK, False), 0x84: ("pong", None, False),
}


def whole(read, data):
    """A message that has to fill the bytes."""
    reader = Reader(data)
    message = read(reader)
    if reader.at != len(data):
        raise ValueError("bytes are left over")
    return message


class Listener:
    """Listens to one direction of a line."""

    def __init__(self):
        self.parts = b""

    def hear(self, data):
        """What the frames in these bytes say."""
        return [self.understand(*frame(piece)) for piece in data.split(b"\0") if piece]

    def understand(self, kind, seq, payload):
        name, content, in_parts = KINDS[kind]
        if content is None:
            return [name, seq, None]
        if not in_parts:
            return [name, seq, whole(content, payload)]
        self.parts += payload[1:]
        if payload[0] & 0x80 == 0:
            return [name, seq, None]
        message, self.parts = self.parts, b""
        return [name, seq, whole(content, message)]


def check_frame(vector):
    kind, seq, payload = frame(bytes.fromhex(vector["bytes"])[:-1])
    return {"kind": kind, "seq": seq, "payload": payload.hex()}


def check_damaged(vector):
    try:
        frame(bytes.fromhex(vector["bytes"])[:-1])
    except Damaged as why:
        return {"why": str(why)}
    return {"why": None}


def check_message(vector):
    return {"message": whole(MESSAGES[vector["type"]], bytes.fromhex(vector["bytes"]))}


def main():
    folder = Path(sys.argv[1])
    listeners = {"host": Listener(), "target": Listener()}
    checks = {
        "frames.json": check_frame,
        "damaged.json": check_damaged,
        "messages.json": check_message,
        "session.json": lambda v: {"says": listeners[v["from"]].hear(bytes.fromhex(v["bytes"]))},
    }
    agreed = 0
    for file, check in checks.items():
        for vector in json.loads((folder / file).read_text(encoding="utf-8")):
            understood = check(vector)
            expected = {key: vector[key] for key in understood}
            if understood != expected:
                sys.exit(f"{file}: {vector}\nreads as {understood}")
            agreed += 1
    print(f"{agreed} vectors agree")


if __name__ == "__main__":
    main()
