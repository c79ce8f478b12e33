#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Describes the artifacts of a release: writes MANIFEST.txt for people, and a bill of materials in
JSON (SPDX 2.3). Both depend on nothing but the artifacts, the lists of pack.sh and the settings.

    describe.py OUTPUT SCRATCH version=V commit=HASH time=SECONDS [notes=LINES] [parts=LIST]
                [repository=URL] [contact=TEXT]

OUTPUT has the artifacts and gets the two files. SCRATCH is that of pack.sh.
"""
import base64
import datetime
import hashlib
import json
import os
import re
import sys
import uuid

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))

# Each artifact: its part, the pattern of its name with V for the version, its package URL, what it is.
ARTIFACTS = (
    ("source", r"scarp-V\.tar\.gz", "pkg:generic/scarp@V", "the sources, as git has them"),
    ("archive", r"scarp-V-[a-z]+-[a-z0-9_]+\.tar\.gz", None,
     "library, program, headers, shaders, for find_package and pkg-config; unpack it anywhere"),
    ("deb", r"(libscarp[0-9.]+)_V-1_(\w+)\.deb", "pkg:deb/scarp/{0}@V-1?arch={1}", "Debian: the library"),
    ("deb", r"(libscarp-dev)_V-1_(\w+)\.deb", "pkg:deb/scarp/{0}@V-1?arch={1}", "Debian: headers and shaders"),
    ("deb", r"(scarp)_V-1_(\w+)\.deb", "pkg:deb/scarp/{0}@V-1?arch={1}", "Debian: the program"),
    ("deb", r"(python3-scarp)_V-1_(\w+)\.deb", "pkg:deb/scarp/{0}@V-1?arch={1}", "Debian: the module for Python"),
    ("single", r"scarp-V-single\.tar\.gz", None, "the library as one file of C, and its header"),
    ("wheel", r"scarp-V-py3-none-\w+\.whl", "pkg:generic/scarp@V", "Python: the wheel, for pip"),
    ("crate", r"scarp-V\.crate", "pkg:cargo/scarp@V", "Rust: the crate"),
    ("npm", r"scarp-noise-V\.tgz", "pkg:npm/scarp-noise@V", "JavaScript: the package for npm, with WebAssembly"),
    ("playground", r"scarp-playground-V\.tar\.gz", None, "the page of the playground, for any server of files"),
    ("csharp", r"scarp-csharp-V\.tar\.gz", None, "C#: the file for .NET, Mono and Unity"),
    ("shaders", r"scarp-shaders-V\.tar\.gz", None, "the shaders in GLSL, HLSL and WGSL"),
)
NAMES = {"cc": "C compiler", "ldd": "libc", "wasm-ld-19": "lld", "zlib": "zlib, its headers", "system": "operating system"}

# What artifacts are linked to or need: licence, where its functions come from
LIBRARIES = {
    "glibc": ("LGPL-2.1-or-later", "DYNAMIC_LINK", "libc and libm of the system, of this version or newer"),
    "zlib": ("Zlib", "DYNAMIC_LINK", "the program compresses PNG by it; of this version or newer"),
    "wasi-libc": ("MIT", "STATIC_LINK", "a few functions that it has from musl, such as memcpy"),
    "numpy": ("BSD-3-Clause", "DEPENDS_ON", "1.20 or newer"),
}


def fail(text):
    sys.exit("describe.py: " + text)


def rows(folder, name):
    """The lines of a list of pack.sh, split at tabs."""
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return [line.rstrip("\n").split("\t") for line in file]


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def describe(name, version):
    """(part, package URL, text) of an artifact."""
    for part, pattern, url, text in ARTIFACTS:
        found = re.fullmatch(pattern.replace("V", re.escape(version)), name)
        if found:
            return part, url and url.replace("V", version).format(*found.groups()), text
    return fail("%s is no artifact that is known" % name)


def identifier(text):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", text)


def package(name, version, licence, purpose, **more):
    made = {"SPDXID": identifier(more.pop("id", name)), "name": name, "versionInfo": version,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": licence,
            "licenseDeclared": licence, "copyrightText": "NOASSERTION", "primaryPackagePurpose": purpose}
    made.update(more)
    return {key: value for key, value in made.items() if value is not None}


def own(scarp, name, version):
    """An artifact as a package."""
    part, url, text = describe(name, version)
    found = package(name, version, "MIT", "SOURCE" if part == "source" else "INSTALL",
                    id="artifact-" + name, packageFileName=name, summary=text,
                    copyrightText=scarp["copyright"], supplier="Organization: the scarp authors",
                    checksums=[{"algorithm": "SHA256", "checksumValue": sha256(scarp["folder"] + "/" + name)}])
    if url:
        found["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                  "referenceLocator": url}]
    return part, found


def bundled(scratch):
    """The npm libraries in the bundle of the playground, as packages."""
    path = os.path.join(scratch, "playground_licenses")
    if not os.path.exists(path):
        return []
    with open(os.path.join(ROOT, "src", "web", "playground", "package-lock.json"), encoding="utf-8") as file:
        locked = json.load(file)["packages"]
    with open(path, encoding="utf-8") as file:
        names = re.findall(r"(?m)^(?:-{72}\n\n)?((?:@[a-z0-9-]+/)?[a-z0-9.-]+) ([0-9]+\.[0-9]+\.[0-9]+)$", file.read())
    found = []
    for name, version in names:
        entry = locked.get("node_modules/" + name, {})
        if entry.get("version") != version:
            fail("the playground has %s %s, which package-lock.json has not" % (name, version))
        algorithm, digest = entry["integrity"].split("-", 1)
        value = base64.b64decode(digest).hex()
        url = "pkg:npm/%s@%s" % (name.replace("@", "%40"), version)
        found.append(package(name, version, entry.get("license", "NOASSERTION"), "LIBRARY", id="npm-" + name,
                             checksums=[{"algorithm": algorithm.upper(), "checksumValue": value}],
                             externalRefs=[{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                            "referenceLocator": url}]))
    return found


def tools(scratch):
    """({name: package}, [(name, part)]) of what parts were made with."""
    packages, users = {}, []
    for part, name, line in rows(scratch, "tools"):
        numbers = re.findall(r"[0-9]+(?:\.[0-9]+)+[^\s,)]*", line.rstrip("."))
        packages[name] = package(NAMES.get(name, name), numbers[-1] if numbers else None, "NOASSERTION", "APPLICATION",
                                 id="tool-" + name, comment=line)
        users.append((name, part))
    return packages, users


def libraries(scratch, parts):
    """([package], [(part, relation, id)]) of what artifacts are linked to or need."""
    packages, uses = {}, []
    lines = rows(scratch, "libraries")
    lines += [[part, "numpy", None] for part in ("wheel", "deb") if part in parts]
    for part, name, version in lines:
        licence, relation, text = LIBRARIES[name]
        made = package(name, version, licence, "LIBRARY", id="library-%s-%s" % (name, version or "any"), comment=text)
        packages[made["SPDXID"]] = made
        uses.append((part, name, relation, made["SPDXID"]))
    return list(packages.values()), uses


def links(artifact, name):
    """Whether an artifact, of those of its part, has anything to do with a library."""
    if artifact.endswith(".deb"):
        kind = artifact.split("_")[0]
        return {"glibc": kind == "scarp" or re.match("libscarp[0-9]", kind), "zlib": kind == "scarp",
                "numpy": kind == "python3-scarp"}.get(name, False)
    return True


def bill(settings, artifacts, scratch):
    """The bill of materials, as a document of SPDX."""
    version = settings["version"]
    time = datetime.datetime.fromtimestamp(int(settings["time"]), datetime.timezone.utc)
    parts = {part for part, _ in artifacts}
    made_with, users = tools(scratch)
    needed, uses = libraries(scratch, parts)
    relations = []

    def relate(one, kind, other):
        relations.append({"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other})

    scarp = package("scarp", version, "MIT", "LIBRARY", copyrightText=settings["copyright"],
                    supplier="Organization: the scarp authors", sourceInfo="commit " + settings["commit"])
    inside = bundled(scratch) if "playground" in parts else []
    relate("SPDXRef-DOCUMENT", "DESCRIBES", scarp["SPDXID"])
    for part, artifact in artifacts:
        me = artifact["SPDXID"]
        if part == "playground":
            licences = {library["licenseDeclared"] for library in inside} | {"MIT"}
            artifact.update(licenseConcluded=" AND ".join(sorted(licences)), licenseDeclared=" AND ".join(sorted(licences)))
        relate("SPDXRef-DOCUMENT", "DESCRIBES", me)
        relate(me, "GENERATED_FROM", scarp["SPDXID"])
        for user, name, relation, library in uses:
            if user == part and links(artifact["name"], name):
                relate(me, relation, library)
        for library in inside if part == "playground" else []:
            relate(me, "CONTAINS", library["SPDXID"])
        for name, user in users:
            if user == part:
                relate(made_with[name]["SPDXID"], "BUILD_TOOL_OF", me)
    packages = [scarp] + [made for _, made in artifacts] + needed + inside + list(made_with.values())
    unique = settings["commit"] + json.dumps(packages)
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
            "name": "scarp-" + version,
            "documentNamespace": "urn:uuid:%s" % uuid.uuid5(uuid.UUID(int=0), unique),
            "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ"),
                             "creators": ["Organization: the scarp authors", "Tool: release.sh-" + version]},
            "packages": packages, "relationships": relations}


def manifest(settings, artifacts, scratch, file):
    time = datetime.datetime.fromtimestamp(int(settings["time"]), datetime.timezone.utc)
    words = ["--%s '%s'" % (name, settings[name]) for name in ("repository", "contact") if settings.get(name)]
    print("scarp %s" % settings["version"], file=file)
    for note in settings.get("notes", "").splitlines():
        print("NO RELEASE: " + note, file=file)
    print("commit %s" % settings["commit"], file=file)
    print("of %s (SOURCE_DATE_EPOCH=%s)" % (time.strftime("%Y-%m-%d %H:%M:%S UTC"), settings["time"]), file=file)
    print("made by " + " ".join(["cmake/release.sh"] + words), file=file)
    print(file=file)
    lines = [(artifact["name"], artifact["summary"]) for _, artifact in artifacts]
    lines.append(("scarp-%s.spdx.json" % settings["version"], "the bill of materials (SPDX 2.3)"))
    needs = {part: line for part, name, line in rows(scratch, "libraries") if name == "glibc" and part != "deb"}
    for (part, _), (name, text) in zip(artifacts + [("", None)], lines):
        print("%-48s %s%s" % (name, text, "; glibc %s or newer" % needs[part] if part in needs else ""), file=file)
    left_out = rows(scratch, "left_out")
    asked = settings.get("parts", "").split(",")
    left_out += [(part, "nobody asked for it") for part in dict.fromkeys(row[0] for row in ARTIFACTS)
                 if asked != [""] and part not in asked]
    for part, why in left_out:
        print("%-48s %s" % ("not here: " + part, why), file=file)
    print("\nMade with:", file=file)
    for line in sorted({row[2] for row in rows(scratch, "tools")}):
        print("  " + line, file=file)


def main(output, scratch, *words):
    settings = dict(word.split("=", 1) for word in words)
    with open(os.path.join(ROOT, "LICENSE"), encoding="utf-8") as file:
        settings["copyright"] = re.search("(?m)^Copyright.*$", file.read()).group(0)
    settings["folder"] = output
    order = [row[0] for row in ARTIFACTS]
    artifacts = sorted((own(settings, name, settings["version"]) for name in os.listdir(output)),
                       key=lambda row: (order.index(row[0]), row[1]["name"]))
    with open(os.path.join(output, "scarp-%s.spdx.json" % settings["version"]), "w", encoding="utf-8") as file:
        json.dump(bill(settings, artifacts, scratch), file, indent=1)
        file.write("\n")
    with open(os.path.join(output, "MANIFEST.txt"), "w", encoding="utf-8") as file:
        manifest(settings, artifacts, scratch, file)


if len(sys.argv) < 6 or not all("=" in word for word in sys.argv[3:]):
    sys.exit(__doc__)
main(*sys.argv[1:])
