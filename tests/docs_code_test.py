#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scripts/check-docs-code finds the mistake in every block of broken_blocks.md, at its line, and no other.

Usage: docs_code_test.py OPTION...    the options of check-docs-code
"""
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = HERE / "broken_blocks.md"


def lines_of(*texts):
    lines = PAGE.read_text().splitlines()
    return {next(number for number, line in enumerate(lines, 1) if text in line) for text in texts}


def main():
    expected = lines_of("return y", "vec4(1.0) }", "float gnomon_k_shadow", "static_assert", "not 0", "find_package",
                        "nothing.spv", '"a"', '"con"', "elevatio", "biuld", "--su ", "nosuch", "defalt", "traget", "fn main")
    done = subprocess.run([HERE.parent / "scripts" / "check-docs-code", *sys.argv[1:], PAGE], capture_output=True, text=True)
    found = {int(number) for number in re.findall(r"broken_blocks\.md:(\d+):(?:\d+:)* error:", done.stderr)}
    if done.returncode != 1 or found != expected:
        sys.exit(f"exit code {done.returncode}; not found: {sorted(expected - found)}, found where nothing is wrong: "
                 f"{sorted(found - expected)}\n{done.stdout}{done.stderr}")
    print(f"{len(found)} mistakes found")


if __name__ == "__main__":
    main()
