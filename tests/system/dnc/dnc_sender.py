#!/usr/bin/env python3
"""A computer at the serial line of a CNC 3300, as the manual describes it (2.5.6, control characters for REMOTE).

    dnc_sender.py DEVICE [--bind LINE] COMMAND...

DEVICE is a serial device or a pseudo-terminal; --bind sends that line first, as a TCP line wants it. Each command waits
for what the control has to say and prints one line:

    send FILE      programs, one per line of the file: waits for DC1 before each, ends each with 00H but the last with "%"
    part FILE      as send, but every line ends with 00H: the control waits for further data
    start PxxxxNxxx
    query          prints the answer without its "%"
    erase
    until LETTER   asks again and again until the status ends with it (S, L or F)
    wait           for DC1: the control asks for data
    refused TEXT   a transmission that is wrong: DC3 twice is the answer to it too

Every byte that comes is checked for even parity. Exit code 0: everything was answered as the manual says; 1: it was not,
the reason goes to stderr. Standard library only; nothing of the control's own sources is used.
"""

import os
import select
import sys
import termios
import time
import tty

READER_ON, READER_OFF = 0x11, 0x13
LIMIT_S = 20.0


class LineError(Exception):
    pass


def with_even_parity(text):
    return bytes(code | (0x80 if bin(code).count("1") % 2 else 0) for code in text.encode("ascii"))


def name_of(code):
    return {READER_ON: "DC1", READER_OFF: "DC3"}.get(code, chr(code))


class Line:
    def __init__(self, device):
        self.fd = os.open(device, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.fd, termios.TCSANOW)
        self.is_reader_on = False

    def write(self, data):
        while data:
            data = data[os.write(self.fd, data):]

    def next(self, limit_s=LIMIT_S):
        """The next character of the control, or None when none comes in time."""
        ready, _, _ = select.select([self.fd], [], [], limit_s)
        if not ready:
            return None
        data = os.read(self.fd, 1)
        if not data:
            raise LineError("the line was closed")
        if bin(data[0]).count("1") % 2:
            raise LineError("odd parity: %02X" % data[0])
        return data[0] & 0x7F

    def expect(self, *codes):
        for code in codes:
            got = self.next()
            if got is None:
                raise LineError("%s did not come" % name_of(code))
            if got != code:
                raise LineError("%s instead of %s" % (name_of(got), name_of(code)))

    def await_reader(self):
        if not self.is_reader_on:
            self.expect(READER_ON)
        self.is_reader_on = False

    def transmit(self, text):
        """One transmission: the control asks, gets it, and switches the reader off."""
        self.await_reader()
        self.write(with_even_parity(text))
        self.expect(READER_OFF, READER_OFF)


def send(line, path, last_end):
    with open(path, encoding="ascii") as file:
        programs = [row.strip() for row in file if row.strip()]
    for index, program in enumerate(programs):
        is_last = index + 1 == len(programs)
        line.transmit(program + (last_end if is_last else "\0"))
    return "sent %d" % len(programs)


def query(line):
    line.write(with_even_parity("!"))
    answer = ""
    while not answer.endswith("%"):
        code = line.next()
        if code is None:
            raise LineError("no answer to the query: " + repr(answer))
        if code == READER_ON:
            line.is_reader_on = True
        elif code != READER_OFF:
            answer += chr(code)
    return answer[:-1]


def query_until(line, letter):
    end = time.monotonic() + LIMIT_S
    answer = query(line)
    while answer[-1] != letter:
        if time.monotonic() > end:
            raise LineError("the status stays at " + answer)
        answer = query(line)
    return answer


def run(line, words):
    while words:
        command = words.pop(0)
        if command == "send":
            print(send(line, words.pop(0), "%"))
        elif command == "part":
            print(send(line, words.pop(0), "\0"))
        elif command == "start":
            line.transmit(words.pop(0) + "*")
            print("started")
        elif command == "query":
            print(query(line))
        elif command == "until":
            print(query_until(line, words.pop(0)))
        elif command == "erase":
            line.transmit("#")
            print("erased")
        elif command == "wait":
            line.await_reader()
            line.is_reader_on = True
            print("asked")
        elif command == "refused":
            line.transmit(words.pop(0))
            print("refused")
        else:
            raise LineError("unknown command " + command)
        sys.stdout.flush()


def main(words):
    if len(words) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        line = Line(words.pop(0))
        if words[0] == "--bind":
            words.pop(0)
            line.write(words.pop(0).encode("ascii") + b"\n")
        run(line, words)
    except (LineError, OSError, IndexError) as error:
        print("dnc_sender: %s" % error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
