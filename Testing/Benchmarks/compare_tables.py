"""Sets two files that BenchmarkTables --json or BenchmarkDrawing --json wrote side by side, measured on two machines
perhaps: compare_tables.py A.json B.json

Prints A, B and B / A for each measured column. Says what only one of them has; the exit status is then 3.
"""

import json
import sys


def number(cell):
    return cell["median"] if isinstance(cell, dict) else cell


def rows_by_name(table):
    names = [column["key"] for column in table["columns"] if column["kind"] == "name"]
    return {", ".join(str(row[name]) for name in names): row for row in table["rows"]}


def compare(key, a, b):
    """Prints what both measured; returns a line for each row that one of them lacks."""
    of_a, of_b = rows_by_name(a), rows_by_name(b)
    for column in a["columns"]:
        lines = []
        for name in of_a.keys() & of_b.keys() if column["kind"] == "measured" else ():
            first, second = number(of_a[name][column["key"]]), number(of_b[name][column["key"]])
            if first and second is not None:
                lines.append(f"  {name:40} {first:14.4g} {second:14.4g} {second / first:8.2f}")
        if lines:
            print(f"{key}: {column['heading']}\n  {'':40} {'A':>14} {'B':>14} {'B / A':>8}", *sorted(lines), "", sep="\n")
    return [f"table {key}: only one has the row {name}" for name in of_a.keys() ^ of_b.keys()]


def main(paths):
    reports = []
    for name, path in zip("AB", paths):
        with open(path, encoding="utf-8") as file:
            reports.append(json.load(file))
        print(f"{name}: {path}: {reports[-1]['processor']}, {reports[-1]['threads']} threads; {reports[-1]['build']}")
    a, b = (report["tables"] for report in reports)
    problems = [f"only one has the table {key}" for key in a.keys() ^ b.keys()]
    if any(reports[0][key] != reports[1][key] for key in ("files", "synthetic")):
        problems.append("A and B measured other files: the ratios compare different work")
    for key in filter(b.get, a):
        problems += compare(key, a[key], b[key])
    print(*problems, sep="\n", file=sys.stderr, end="\n" if problems else "")
    return 3 if problems else 0


if len(sys.argv) != 3:
    sys.exit(__doc__)
sys.exit(main(sys.argv[1:]))
