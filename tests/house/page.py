#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the page (reference/paper) stays short, and that its README names every public function.

usage: page.py [--root FOLDER] [--list] [--self-test]
  --list        also prints the functions of each file
  --self-test   checks that planted breaches are found

A line of code is a line that is not empty and not only a comment. The tables and the equations count as part of the page.
Exit code 0: all is well; 1: each breach is printed.
"""
import argparse
import pathlib
import re
import sys
import tempfile

MOST_LINES = 1200
SHARED = ("reference/tables.hpp", "reference/equations.hpp")
# A definition at the level of the namespace or of the class: return type, name, arguments, body. Sources are formatted, so the
# indentation tells the level. A constructor has no return type and is not listed.
FUNCTION = re.compile(r"^(?:  )?(?=\w)(?:[\w:<>,&*\[\] ]+[ &*])(\w+)\([^;{}]*\)(?: const)?(?: override)? \{", re.M)
HIDDEN = re.compile(r"^ (?:private|protected):.*?^\};", re.M | re.S)
NOT_TYPES = re.compile(r"^\s*(?:return|else|case|throw|new|if|for|while)\b")
CODE = re.compile(r"`([^`]+)`")


def lines_of_code(text):
    return sum(1 for line in text.splitlines() if line.strip() and not line.strip().startswith("//"))


def functions_of(text):
    """The names of the public functions that a header defines, in its order."""
    found = [match.group(1) for match in FUNCTION.finditer(HIDDEN.sub("", text)) if not NOT_TYPES.match(match.group(0))]
    return list(dict.fromkeys(found))


def breaches_of(root, show=False):
    """Every breach below `root`, one text each."""
    headers = sorted((root / "reference/paper").glob("*.hpp"))
    if not headers:
        sys.exit(f"page.py: no headers in {root}/reference/paper")
    texts = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in headers + [root / name for name in SHARED]}
    breaches = []
    lines = {name: lines_of_code(text) for name, text in texts.items()}
    total = sum(lines.values())
    if total > MOST_LINES:
        each = ", ".join(f"{name} {count}" for name, count in lines.items())
        breaches.append(f"the page has {total} lines of code, {total - MOST_LINES} more than {MOST_LINES}: {each}")
    readme = root / "reference/paper/README.md"
    named, first_cells = set(), set()
    if readme.is_file():
        for line in readme.read_text(encoding="utf-8").splitlines():
            for code in CODE.findall(line):
                named.update(re.findall(r"\w+", code))
            if line.startswith("|"):
                for code in CODE.findall(line.split("|")[1]):
                    first_cells.update(re.findall(r"\w+", code))
    else:
        breaches.append("reference/paper/README.md is missing")
    count = 0
    for name, text in texts.items():
        functions = functions_of(text)
        if show:
            print(f"{name}: {' '.join(functions)}")
        if name in SHARED:
            continue
        count += len(functions)
        missing = [function for function in functions if function not in named]
        if missing and readme.is_file():
            breaches.append(f"{name}: reference/paper/README.md does not name {', '.join(missing)}")
    words = set(re.findall(r"\w+", "\n".join(texts.values())))
    stale = sorted(first_cells - words)
    if stale:
        breaches.append(f"reference/paper/README.md names what the page does not have: {', '.join(stale)}")
    print(f"{total} lines of code, {count} functions, {len(breaches)} breaches")
    return breaches


HEADER = """// A comment.
inline bool is_free(const Point& p) {
  return p.x() > 0;
}

/// Another.
template <std::size_t N>
std::array<int, N> two(const std::array<int, N>& a,
                       int b) {
  std::sort(a.begin(), a.end());
  if (b > 0) { return a; }
  return a;
}

class Page {
 public:
  Page(int a) : a_(a) { two(a, a); }
  virtual int member(int x) const { return x; }
  static std::vector<int>& other() {
    const auto lambda = [](int y) { return y; };
    return lambda(3);
  }

 private:
  int hidden() const { return a_; }
  int a_;
};
"""


def self_test():
    """Plants one breach of each kind in a small page; returns what was not found, or found wrongly."""
    wrong = []
    if functions_of(HEADER) != ["is_free", "two", "member", "other"]:
        wrong.append(f"found the functions {functions_of(HEADER)}")
    row = "| `is_free`, `two` | `member`, then `other(x)` |\n"
    sound = {"reference/paper/page.hpp": HEADER, "reference/paper/README.md": row, **{name: "int x;\n" for name in SHARED}}
    rest = MOST_LINES - lines_of_code(HEADER) - len(SHARED)
    filler = "int x;\n\n  // no code\n"
    planted = [
        (None, {}),
        (None, {"reference/paper/rest.hpp": filler * rest}),
        (f"has {MOST_LINES + 1} lines of code", {"reference/paper/rest.hpp": filler * (rest + 1)}),
        ("does not name member", {"reference/paper/README.md": "| `is_free`, `two`| `other`; member |\n"}),
        ("does not have: gone", {"reference/paper/README.md": row + "| `gone` | a step |\n"}),
        ("README.md is missing", {"reference/paper/README.md": None}),
    ]
    for expected, files in planted:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "reference/paper").mkdir(parents=True)
            for name, text in {**sound, **files}.items():
                if text is not None:
                    (root / name).write_text(text)
            found = breaches_of(root)
        if (expected is None and found) or (expected and not (len(found) == 1 and expected in found[0])):
            wrong.append(f"expected {expected}, found {found}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    found = self_test() if options.self_test else breaches_of(options.root, options.list)
    for breach in found:
        print(breach)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
