#!/usr/bin/env python3
"""Draws a terminal's screen as SVG: text as text, bars and dots as shapes, so that
no font is needed that has them.

    tmux capture-pane -e -p -N | python3 screen_svg.py > screen.svg
"""
import re
import sys
from html import escape

WIDE, HIGH = 8.4, 17  # of a cell
INK, PAPER = "#d6d9de", "#16191e"
BASIC = (
    "#3b4048 #e06c75 #8cc570 #e0b95f #61afef #c678dd #56b6c2 #c8ccd4 "
    "#7b818c #ff7b86 #a5e075 #f0cb6f #7cc3ff #d992f0 #6fd0dc #ffffff"
).split()
# Braille dots, bit by bit: column and row.
DOTS = ((0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3))
# Corners and lines of boxes: which of left, right, up, down they reach.
LINES = {
    "─": "lr", "━": "lr", "│": "ud", "┃": "ud", "┌": "rd", "┐": "ld", "└": "ru",
    "┘": "lu", "├": "rud", "┤": "lud", "┬": "lrd", "┴": "lru", "┼": "lrud", "╌": "lr",
}  # fmt: skip


def colour_of(code):
    """One of the terminal's 256 colours."""
    if code < 16:
        return BASIC[code]
    if code >= 232:
        return "#" + f"{8 + 10 * (code - 232):02x}" * 3
    levels = (0, 95, 135, 175, 215, 255)
    code -= 16
    return "#" + "".join(
        f"{levels[k]:02x}" for k in (code // 36, code // 6 % 6, code % 6)
    )


class Pen:
    """What escape sequences say of the characters behind them."""

    def __init__(self):
        self.change([0])

    def change(self, codes):
        codes = list(codes)
        while codes:
            code = codes.pop(0)
            if code == 0:
                self.ink, self.paper = INK, PAPER
                self.bold = self.dim = self.turned = False
            elif code in (1, 2, 7):
                setattr(self, {1: "bold", 2: "dim", 7: "turned"}[code], True)
            elif code == 22:
                self.bold = self.dim = False
            elif code == 27:
                self.turned = False
            elif code in (38, 48):
                if codes.pop(0) == 5:
                    colour = colour_of(codes.pop(0))
                else:
                    colour = "#" + "".join(f"{codes.pop(0):02x}" for _ in range(3))
                setattr(self, "ink" if code == 38 else "paper", colour)
            elif code in (39, 49):
                self.ink = INK if code == 39 else self.ink
                self.paper = PAPER if code == 49 else self.paper
            elif 30 <= code < 38 or 90 <= code < 98:
                self.ink = BASIC[code % 10 + (8 if code >= 90 else 0)]
            elif 40 <= code < 48 or 100 <= code < 108:
                self.paper = BASIC[code % 10 + (8 if code >= 100 else 0)]

    def look(self):
        ink, paper = self.ink, self.paper
        return (paper, ink, self.bold, False) if self.turned else (
            ink, paper, self.bold, self.dim)  # fmt: skip


def cells(line, pen):
    """Characters with their look."""
    for part in re.split(r"(\x1b\[[\d;:]*m)", line):
        if part.startswith("\x1b["):
            pen.change(int(n or 0) for n in re.split("[;:]", part[2:-1]))
        else:
            for character in part:
                yield character, pen.look()


def rectangle(x, y, width, height, colour):
    return (
        f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}"'
        f' fill="{colour}"/>'
    )


def shape(character, x, y, ink):
    """Of a character that is drawn and not written; None of any other."""
    code = ord(character)
    if 0x2800 < code <= 0x28FF:
        path = "".join(
            f"M{x + WIDE * (1 + 2 * i) / 4:.1f} {y + HIGH * (1 + 2 * j) / 8:.1f}h0"
            for bit, (i, j) in enumerate(DOTS)
            if code >> bit & 1
        )
        return (
            f'<path d="{path}" stroke="{ink}" stroke-width="2.4"'
            ' stroke-linecap="round"/>'
        )
    if 0x2581 <= code <= 0x2588:
        height = HIGH * (code - 0x2580) / 8
        return rectangle(x, y + HIGH - height, WIDE, height, ink)
    if 0x2589 <= code <= 0x258F:
        return rectangle(x, y, WIDE * (0x2590 - code) / 8, HIGH, ink)
    if character in LINES:
        ends = {"l": (0, 0.5), "r": (1, 0.5), "u": (0.5, 0), "d": (0.5, 1)}
        path = "".join(
            f"M{x + WIDE / 2:.1f} {y + HIGH / 2:.1f}"
            f"L{x + WIDE * ends[to][0]:.1f} {y + HIGH * ends[to][1]:.1f}"
            for to in LINES[character]
        )
        width = 2 if character in "━┃" else 1
        dashes = ' stroke-dasharray="2 1"' if character == "╌" else ""
        return f'<path d="{path}" stroke="{ink}" stroke-width="{width}"{dashes}/>'
    return None


def drawn_line(row, line):
    """The papers, shapes and words of a line of cells."""
    y = row * HIGH
    out, at = [], 0
    while at < len(line):
        look = line[at][1]
        end = at
        while end < len(line) and line[end][1] == look:
            end += 1
        ink, paper, bold, dim = look
        if paper != PAPER:
            out.append(rectangle(at * WIDE, y, (end - at) * WIDE + 0.3, HIGH, paper))
        run = [character for character, _ in line[at:end]]
        for k, character in enumerate(run):
            drawn = shape(character, (at + k) * WIDE, y, ink)
            if drawn is not None:
                out.append(drawn)
                run[k] = " "
        style = (' font-weight="bold"' if bold else "") + (
            ' opacity="0.6"' if dim else "")  # fmt: skip
        for word in re.finditer(r"\S+(?: \S+)*", "".join(run)):
            length = (word.end() - word.start()) * WIDE
            out.append(
                f'<text x="{(at + word.start()) * WIDE:.1f}" y="{y + 13}"'
                f' textLength="{length:.1f}" fill="{ink}"{style}>'
                f"{escape(word.group())}</text>"
            )
        at = end
    return out


def main():
    pen = Pen()
    lines = [list(cells(line, pen)) for line in sys.stdin.read().splitlines()]
    width = max(map(len, lines)) * WIDE
    height = len(lines) * HIGH
    print(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-8 -8 {width + 16:.0f}'
        f' {height + 16}" font-family="DejaVu Sans Mono,Menlo,Consolas,monospace"'
        f' font-size="14" xml:space="preserve">'
    )
    print(f'<rect x="-8" y="-8" width="100%" height="100%" rx="6" fill="{PAPER}"/>')
    for row, line in enumerate(lines):
        print("\n".join(drawn_line(row, line)))
    print("</svg>")


if __name__ == "__main__":
    main()
