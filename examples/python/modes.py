#!/usr/bin/env python3
"""Reads what tapfit prints with --json: the modes of a bundle, and a bar of each
one's damping where matplotlib is there.

    python3 modes.py BUNDLE [PICTURE.png]
"""
import json
import subprocess
import sys


def results(command, bundle):
    """The JSON object of one command; its message where it fails."""
    done = subprocess.run(
        ["tapfit", command, bundle, "--json"], capture_output=True, text=True
    )
    if done.returncode != 0:
        sys.exit(done.stderr.strip())
    return json.loads(done.stdout)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    modes = results("modes", sys.argv[1])["modes"]
    for mode in modes:
        frequency, damping = mode["frequency_hz"], mode["damping_ratio"]
        print(
            f"{frequency['value']:10.4f} +- {frequency['sd']:.2g} Hz"
            f"  {100 * damping['value']:7.4f} +- {100 * damping['sd']:.2g} %"
        )
    if len(sys.argv) < 3:
        return
    try:
        from matplotlib import pyplot
    except ImportError:
        sys.exit("no picture: matplotlib is not installed")
    pyplot.bar(
        [f"{m['frequency_hz']['value']:.1f}" for m in modes],
        [100 * m["damping_ratio"]["value"] for m in modes],
        yerr=[100 * m["damping_ratio"]["sd"] for m in modes],
    )
    pyplot.xlabel("Hz")
    pyplot.ylabel("damping [%]")
    pyplot.savefig(sys.argv[2])


if __name__ == "__main__":
    main()
