#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the units and prefixes of the installed UDUNITS-2 as a table for C++ (src/base/unit_table.cpp).

Usage: make_unit_table.py OUTPUT.hpp

UDUNITS-2 itself evaluates each unit, so the factors of single units are its own to the last bit.
"""
import ctypes
import ctypes.util
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

FOLDER = pathlib.Path("/usr/share/xml/udunits")
BASE = ["m", "kg", "s", "A", "K", "mol", "cd", "rad"]
UTF8, DEFINITION = 2, 8  # ut_encoding, UT_DEFINITION
TEMPLATE = pathlib.Path(__file__).resolve().parent.parent.parent / "src/base/unit_table_data.hpp.in"


class Library:
    """The functions of UDUNITS-2 that the table needs."""

    def __init__(self):
        self.c = ctypes.CDLL(ctypes.util.find_library("udunits2") or "libudunits2.so.0")
        for name in ["ut_read_xml", "ut_parse", "ut_get_unit_by_name", "ut_get_unit_by_symbol", "ut_get_converter"]:
            getattr(self.c, name).restype = ctypes.c_void_p
        self.c.cv_convert_double.restype = ctypes.c_double
        self.c.ut_set_error_message_handler(self.c.ut_ignore)
        self.system = ctypes.c_void_p(self.c.ut_read_xml(None))
        if not self.system:
            sys.exit("make_unit_table.py: the database of UDUNITS-2 cannot be read (Debian: libudunits2-data)")

    def get(self, name, is_symbol):
        find = self.c.ut_get_unit_by_symbol if is_symbol else self.c.ut_get_unit_by_name
        return find(self.system, name.encode())

    def define(self, unit):
        """Factor, offset and powers; None for units that are not linear."""
        text = ctypes.create_string_buffer(256)
        self.c.ut_format(ctypes.c_void_p(unit), text, 256, UTF8 | DEFINITION)
        tokens = re.split(r"[·\s]+", text.value.decode().split(" @")[0].strip("()"))
        tokens = [token for token in tokens if not re.fullmatch(r"[-+0-9.e]+", token)]
        signs = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
        powers = [0] * len(BASE)
        for token in tokens:
            found = re.fullmatch(r"([A-Za-z]+)(-?\d*)", token.translate(signs))
            if not found or found[1] not in BASE:
                return None
            powers[BASE.index(found[1])] += int(found[2] or 1)
        plain = " ".join(f"{name}{power}" for name, power in zip(BASE, powers) if power) or "1"
        base = ctypes.c_void_p(self.c.ut_parse(self.system, plain.encode(), 0))
        convert = self.c.ut_get_converter(ctypes.c_void_p(unit), base)
        if not convert:
            return None
        at = [self.c.cv_convert_double(ctypes.c_void_p(convert), ctypes.c_double(x)) for x in (0.0, 1.0)]
        return (at[1] - at[0], at[0], powers)


def list_plurals(name):
    return [name, name + "s", name + "es", name[:-1] + "ies"]


def read_names():
    """Names and symbols of units, and prefixes with their factors, in the order of the files."""
    units, prefixes = {}, {}
    for path in sorted(FOLDER.glob("udunits2-*.xml")):
        for element in ElementTree.parse(path).getroot():
            if element.tag == "prefix":
                value = float(element.find("value").text)
                for kind in ("name", "symbol"):
                    for found in element.iter(kind):
                        prefixes[found.text.strip(), kind == "symbol"] = value
            for found in element.iter("symbol") if element.tag == "unit" else []:
                units[found.text.strip(), True] = True
            for kind in ("singular", "plural", "noplural") if element.tag == "unit" else []:
                for found in element.iter(kind):
                    for name in list_plurals((found.text or "").strip()) if found.text else []:
                        for form in {name, name.replace(" ", "_"), name.replace("_", " ")}:
                            units[form, False] = True
    return units, prefixes


def write(path):
    library = Library()
    units, prefixes = read_names()
    rows = []
    for name, is_symbol in sorted(units):
        unit = library.get(name, is_symbol)
        found = library.define(unit) if unit else None
        if found:
            factor, offset, powers = found
            rows.append((name, is_symbol, repr(factor), repr(offset), "{" + ", ".join(map(str, powers)) + "}"))
    quote = lambda name: '"' + name.replace("\\", "\\\\").replace('"', '\\"') + '"'  # noqa: E731
    word = {True: "true", False: "false"}
    values = {
        "UNIT_COUNT": str(len(rows)),
        "UNITS": "".join(f"    {{{quote(n)}, {word[i]}, {f}, {o}, {{{p}}}}},\n" for n, i, f, o, p in rows),
        "PREFIX_COUNT": str(len(prefixes)),
        "PREFIXES": "".join(f"    {{{quote(n)}, {word[i]}, {v!r}}},\n" for (n, i), v in sorted(prefixes.items())),
    }
    text = re.sub(r"@(\w+)@\n?", lambda found: values[found[1]], TEMPLATE.read_text(encoding="utf-8"))
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")
    return len(rows), len(prefixes)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("unit table: {} units, {} prefixes".format(*write(sys.argv[1])))
