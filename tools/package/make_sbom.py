#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lists what the program is made of and loaded with, with versions and licences, as SPDX 2.3.

Usage: tools/package/make_sbom.py PROGRAM FILE

Shared libraries: what the loader loads, by the Debian packages they are from. Headers that are compiled in: the packages of
tools/apt-packages.txt that COMPILED_IN names. The report page: the packages of web/package-lock.json that are no tools of development.
A licence is what Debian's copyright file says of a package's main files, where that is machine-readable and a licence of SPDX's list; the
whole file stands in the document elsewhere.
"""
import datetime
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Debian package → why: libraries of headers alone
COMPILED_IN = ["libeigen3-dev", "libcli11-dev", "nlohmann-json3-dev", "libboost-dev", "pybind11-dev"]
# Words of Debian's copyright files → SPDX
SPDX = {"expat": "MIT", "mit": "MIT", "apache-2.0": "Apache-2.0", "apache-2": "Apache-2.0", "bsd-3-clause": "BSD-3-Clause",
        "bsd-2-clause": "BSD-2-Clause", "zlib": "Zlib", "gpl-2+": "GPL-2.0-or-later", "gpl-2.0+": "GPL-2.0-or-later", "mpl-2": "MPL-2.0", "cc0-1.0": "CC0-1.0", "gpl-2": "GPL-2.0-only", "gpl-3+": "GPL-3.0-or-later",
        "gpl-3": "GPL-3.0-only", "lgpl-2.1+": "LGPL-2.1-or-later", "lgpl-2.1": "LGPL-2.1-only", "lgpl-2+": "LGPL-2.0-or-later",
        "lgpl-3+": "LGPL-3.0-or-later", "mpl-2.0": "MPL-2.0", "bsl-1.0": "BSL-1.0", "isc": "ISC", "ftl": "FTL", "openssl": "OpenSSL"}


def ask(*words):
    return subprocess.run(words, capture_output=True, text=True, check=False).stdout


def list_linked(program):
    """The Debian packages of the libraries that the loader loads for the program and for the modules beside it."""
    modules = sorted(pathlib.Path(program).parent.glob("libtalus_*.so"))
    files = sorted({file for binary in (program, *modules) for file in re.findall(r"=> (/\S+)", ask("ldd", str(binary)))})
    packages = set()
    for file in files:
        for path in (file, str(pathlib.Path(file).resolve()), str(pathlib.Path(file).resolve()).removeprefix("/usr")):
            if owner := ask("dpkg-query", "-S", path):
                packages.add(owner.split(":")[0])
                break
        else:
            raise SystemExit(f"make_sbom: no package owns {file}")
    return sorted(packages)


def find_licence(package, texts):
    """The licence of the package's main files; one that SPDX has no name for goes into `texts`."""
    text = (pathlib.Path("/usr/share/doc") / package / "copyright").read_text(errors="replace")
    found = re.search(r"^Files:\s*\*\s*\n(?:.*\n)*?^License:[ \t]*(\S.*)$", text, re.M)
    words = re.split(r"\s+(or|and)\s+", found[1].strip()) if found else [""]
    known = [word.upper() if word in ("or", "and") else SPDX.get(word.lower().rstrip(","), "") for word in words]
    if all(known):
        return " ".join(known)
    name = f"LicenseRef-{package.replace('+', '-')}"
    texts[name] = {"licenseId": name, "name": found[1].strip() if found else f"of {package}", "extractedText": text}
    return name


def describe(name, version, licence, kind, supplier):
    return {"SPDXID": "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", f"{kind}-{name}"), "name": name, "versionInfo": version,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "supplier": supplier, "licenseConcluded": "NOASSERTION",
            "licenseDeclared": licence, "copyrightText": "NOASSERTION"}


def describe_debian(package, kind, texts):
    version = ask("dpkg-query", "-W", "-f", "${Version}", package)
    if not version:
        raise SystemExit(f"make_sbom: {package} is not installed")
    return describe(package, version, find_licence(package, texts), kind, "Organization: Debian")


def list_page():
    """Packages of the report page that are in it."""
    lock = json.loads((ROOT / "web" / "package-lock.json").read_text())["packages"]
    return [describe(path.rpartition("node_modules/")[2], entry["version"], entry.get("license", "NOASSERTION"), "npm", "Organization: npm")
            for path, entry in sorted(lock.items()) if path and not entry.get("dev") and not entry.get("devOptional") and not entry.get("optional")]


def main():
    program, out = sys.argv[1], pathlib.Path(sys.argv[2])
    told = ask(program, "version")
    version = told.split()[1]
    texts = {}
    parts = [(describe_debian(package, "deb", texts), "DYNAMIC_LINK") for package in list_linked(program)]
    parts += [(describe_debian(package, "header", texts), "CONTAINS") for package in COMPILED_IN]
    parts += [(part, "CONTAINS") for part in list_page()]
    talus = describe("talus", version, "MIT", "talus", "Organization: the Talus authors")
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"talus-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/talus-{version}-{re.sub(r'[^0-9a-f]', '', told.partition('source ')[2].split(',')[0])}",
        "creationInfo": {"created": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": ["Tool: make_sbom"]},
        "hasExtractedLicensingInfos": [texts[name] for name in sorted(texts)],
        "packages": [talus, *(part for part, _ in parts)],
        "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": talus["SPDXID"]},
                          *({"spdxElementId": talus["SPDXID"], "relationshipType": relation, "relatedSpdxElement": part["SPDXID"]}
                            for part, relation in parts)]}
    out.write_text(json.dumps(document, indent=1) + "\n")
    print(f"{out}: {len(parts)} parts, {len(texts)} with the whole text of their licence")


if __name__ == "__main__":
    main()
