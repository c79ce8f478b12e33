# SPDX-License-Identifier: MIT
"""cmake/release.sh refuses what is no release and says why, gives the same bytes each time, notices what
does not, and describes its artifacts. Parts that compile the library are left to the release itself.

    test_release.py SOURCE_DIR SCRATCH_DIR C_COMPILER
"""
import datetime
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import unittest

SOURCE, SCRATCH, COMPILER = sys.argv[1:]
REPOSITORY = os.path.join(SCRATCH, "repository")
OUTPUT = os.path.join(SCRATCH, "output")
PARTS = "source,csharp,shaders"
# What the script and its parts read
TREE = ("CHANGELOG.md", "LICENSE", "cmake", "include", "src", "tests")
HIDDEN = {"abidiff", "cargo", "clang-19"} # programs that it must not find
TIME = "1700000000 +0000"


def links(folder):
    """A folder of links to all programs there are but the hidden ones."""
    os.makedirs(folder)
    for place in os.environ["PATH"].split(":"):
        for name in os.listdir(place) if os.path.isdir(place) else []:
            if name not in HIDDEN and not os.path.lexists(os.path.join(folder, name)):
                os.symlink(os.path.join(place, name), os.path.join(folder, name))
    return folder


def git(*words):
    return subprocess.run(["git", "-C", REPOSITORY, *words], check=True, env=ENVIRONMENT, text=True,
                          stdout=subprocess.PIPE).stdout.strip()


def path(name):
    return os.path.join(REPOSITORY, name)


def edit(name, old, new):
    """Replaces a text of a file in the checkout, which must be there, once."""
    with open(path(name), encoding="utf-8") as file:
        text = file.read()
    assert old in text, (name, old)
    with open(path(name), "w", encoding="utf-8") as file:
        file.write(text.replace(old, new, 1))


def commit(*tag):
    git("commit", "-q", "-a", "-m", "changed")
    if tag:
        git("tag", *tag)


def release(*options, output=OUTPUT, programs=None):
    environment = dict(ENVIRONMENT, **({"PATH": programs} if programs else {}))
    return subprocess.run([path("cmake/release.sh"), "--parts", PARTS, *options, output], env=environment,
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def read(name):
    with open(os.path.join(OUTPUT, name), "rb") as file:
        return file.read()


class Release(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        git("init", "-q", "-b", "main")
        git("add", "-A")
        git("commit", "-q", "-m", "first")
        cls.first = git("rev-parse", "HEAD")

    def setUp(self):
        shutil.rmtree(OUTPUT, ignore_errors=True)
        git("reset", "-q", "--hard", self.first)
        git("clean", "-q", "-f", "-d")
        for tag in git("tag").split():
            git("tag", "-d", tag)
        with open(path("CHANGELOG.md"), encoding="utf-8") as file:
            heading = re.search("(?m)^## .*$", file.read()).group(0)
        self.version = heading.split()[1]
        self.dated = lambda: edit("CHANGELOG.md", heading, "## %s (2026-12-01)" % self.version)
        self.undated = lambda: edit("CHANGELOG.md", heading, "## %s (soon)" % self.version)

    def tearDown(self):
        kept, self.kept = getattr(self, "kept", []), []
        left = [name for name in os.listdir(TEMPORARY) if name.startswith("scarp-release")]
        for name in left:
            shutil.rmtree(os.path.join(TEMPORARY, name))
        self.assertEqual(left, kept)

    def refused(self, text, *options, **more):
        run = release(*options, **more)
        self.assertEqual(run.returncode, 2, run.stdout + run.stderr)
        self.assertRegex(run.stderr, text)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertFalse(os.path.exists(os.path.join(OUTPUT, "SHA256SUMS")))

    def test_options(self):
        self.refused("there is no option --fast", "--fast")
        self.refused("there is no part tarball", "--parts", "source,tarball")
        self.refused("not two", "elsewhere")
        os.makedirs(OUTPUT)
        with open(os.path.join(OUTPUT, "file"), "w", encoding="utf-8"):
            pass
        self.refused("is not empty", "--rehearse")
        self.refused("--fuzz takes seconds, 999999 at most, not 1h", "--fuzz", "1h", output=os.path.join(OUTPUT, "new"))
        self.refused("is no folder", "--rehearse", output=os.path.join(OUTPUT, "file"))

    def test_commit(self):
        with open(path("new.txt"), "w", encoding="utf-8"):
            pass
        self.refused("not what is committed: .. new.txt", "--rehearse")
        os.remove(path("new.txt"))
        os.rename(path(".git"), path("../git"))
        try:
            self.refused("is no checkout of git", "--rehearse")
        finally:
            os.rename(path("../git"), path(".git"))

    def test_versions(self):
        found = '"version": "%s"' % self.version
        for name, old in (("cmake/packaging/vcpkg/vcpkg.json", found), ("src/bindings/interface.json", found),
                          ("src/bindings/rust/Cargo.toml", 'version = "%s"' % self.version),
                          ("src/bindings/rust/Cargo.lock", 'version = "%s"' % self.version),
                          ("src/bindings/rust/src/ffi.rs", '"%s"' % self.version),
                          ("src/bindings/python/scarp/_interface.py", "'%s'" % self.version),
                          ("src/web/package.json.in", "@PROJECT_VERSION@"),
                          ("CHANGELOG.md", "## %s" % self.version)):
            with self.subTest(name):
                edit(name, old, old.replace(self.version, "9.8.7").replace("@PROJECT_VERSION@", "9.8.7"))
                commit()
                self.refused("%s has the version 9.8.7, include/scarp.h has %s" % (name, self.version), "--rehearse")
                git("reset", "-q", "--hard", self.first)

    def test_changelog_and_tag(self):
        tag = "v" + self.version
        self.undated()
        commit("-a", tag, "-m", "a tag")
        self.refused("CHANGELOG.md has no date")
        git("reset", "-q", "--hard", self.first)
        self.dated()
        git("tag", "-d", tag)
        commit()
        self.refused("there is no tag " + tag)
        git("tag", tag)
        self.refused("is not annotated")
        git("tag", "-f", "-a", tag, "-m", "a tag", self.first)
        self.refused("is another commit")

    def test_golden(self):
        with open(path("tests/golden.txt"), encoding="utf-8") as file:
            line = file.readline().rstrip("\n")
        self.dated()
        edit("tests/golden.txt", line, line + "\nnew/line 0123456789abcdef added")
        commit("-a", "v" + self.version, "-m", "a tag")
        self.refused("lines that are not frozen: 1$")
        run = release("--rehearse", "--once", "--parts", "shaders")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("\nNO RELEASE: tests/golden.txt has lines that are not frozen: 1\n", read("MANIFEST.txt").decode())
        shutil.rmtree(OUTPUT)
        git("reset", "-q", "--hard", self.first)
        git("tag", "-d", "v" + self.version)
        edit("tests/golden.txt", line, line[:-1] + ("0" if line[-1] != "0" else "1"))
        commit()
        self.refused("golden.txt is not as it was frozen: .*released", "--rehearse")

    @unittest.skipUnless(shutil.which("abidiff") and shutil.which("abidw"), "there is no abidiff")
    def test_interface(self):
        edit("include/scarp.h", "SCARP_API const char *scarp_version(void)",
             "SCARP_API const char *scarp_versions(void);\nSCARP_API const char *scarp_version(void)")
        edit("src/calls/names.c", "#include \"scarp.h\"",
             "#include \"scarp.h\"\nconst char *scarp_versions(void) { return 0; }")
        self.dated()
        commit("-a", "v" + self.version, "-m", "a tag")
        self.refused("abi.xml is not what the sources say; renew it", programs=os.environ["PATH"])

    def test_tools(self):
        run = release("--rehearse", "--once", "--parts", "crate,shaders")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("crate is left out: there is no cargo", run.stderr)
        self.assertRegex(read("MANIFEST.txt").decode(), "not here: crate +there is no cargo")
        shutil.rmtree(OUTPUT)
        self.refused("abidiff is missing", "--rehearse", "--once", "--parts", "crate", "--require-all")

    def test_bytes(self):
        self.dated()
        commit("-a", "v" + self.version, "-m", "a tag")
        run = release("--repository", "https://example.org/scarp.git")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("clang-19 is missing: the fuzz targets are not run\n", run.stdout)
        sums = dict(reversed(line.split("  ")) for line in read("SHA256SUMS").decode().splitlines())
        names = {"scarp-%s.tar.gz", "scarp-csharp-%s.tar.gz", "scarp-shaders-%s.tar.gz", "scarp-%s.spdx.json"}
        names = {name % self.version for name in names} | {"MANIFEST.txt"}
        self.assertEqual(set(sums), names)
        self.assertEqual(set(os.listdir(OUTPUT)), names | {"SHA256SUMS"})
        for name, digest in sums.items():
            self.assertEqual(hashlib.sha256(read(name)).hexdigest(), digest, name)

        head = git("rev-parse", "HEAD")
        manifest = read("MANIFEST.txt").decode()
        self.assertTrue(manifest.startswith("scarp %s\ncommit %s\n" % (self.version, head)), manifest)
        self.assertIn("--repository 'https://example.org/scarp.git'\n", manifest)
        self.assertNotIn("NO RELEASE", manifest)
        self.check_bill(json.loads(read("scarp-%s.spdx.json" % self.version)), sums, head)
        self.check_archives()

        shutil.rmtree(OUTPUT)
        run = release("--once", "--repository", "https://example.org/scarp.git")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertNotIn("fuzz", run.stdout)
        again = dict(reversed(line.split("  ")) for line in read("SHA256SUMS").decode().splitlines())
        self.assertEqual(again, sums)

    def check_archives(self):
        top = "scarp-%s/" % self.version
        with tarfile.open(os.path.join(OUTPUT, "scarp-%s.tar.gz" % self.version)) as archive:
            files = {entry.name for entry in archive if not entry.isdir()}
            modes = {entry.mode for entry in archive}
        self.assertEqual(files, {top + name for name in git("ls-files").splitlines()})
        self.assertEqual(modes, {0o755, 0o644})
        for name in ("csharp", "shaders"):
            with tarfile.open(os.path.join(OUTPUT, "scarp-%s-%s.tar.gz" % (name, self.version))) as archive:
                entries = archive.getmembers()
            self.assertIn("scarp-%s-%s/LICENSE" % (name, self.version), [entry.name for entry in entries])
            self.assertEqual([entry.name for entry in entries], sorted(entry.name for entry in entries))
            for entry in entries:
                self.assertEqual((entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname),
                                 (1700000000, 0, 0, "", ""))
                self.assertEqual(entry.mode, 0o755 if entry.isdir() else 0o644)

    def check_bill(self, bill, sums, head):
        """What SPDX 2.3 requires of a document, and that all artifacts are in it."""
        self.assertEqual((bill["spdxVersion"], bill["dataLicense"], bill["SPDXID"]),
                         ("SPDX-2.3", "CC0-1.0", "SPDXRef-DOCUMENT"))
        self.assertTrue(bill["name"])
        self.assertRegex(bill["documentNamespace"], "^urn:uuid:[0-9a-f-]{36}$")
        time = datetime.datetime.strptime(bill["creationInfo"]["created"], "%Y-%m-%dT%H:%M:%SZ")
        self.assertEqual(time, datetime.datetime(2023, 11, 14, 22, 13, 20))
        self.assertTrue(bill["creationInfo"]["creators"])
        for creator in bill["creationInfo"]["creators"]:
            self.assertRegex(creator, "^(Person|Organization|Tool): ")
        names, found = set(), {}
        for package in bill["packages"]:
            self.assertRegex(package["SPDXID"], "^SPDXRef-[A-Za-z0-9.-]+$")
            self.assertNotIn(package["SPDXID"], names)
            names.add(package["SPDXID"])
            self.assertTrue(package["name"])
            self.assertEqual(package["downloadLocation"], "NOASSERTION")
            self.assertFalse(package["filesAnalyzed"])
            self.assertIn(package["primaryPackagePurpose"], ("SOURCE", "INSTALL", "LIBRARY", "APPLICATION"))
            for field in ("licenseConcluded", "licenseDeclared", "copyrightText"):
                self.assertTrue(package[field])
            for reference in package.get("externalRefs", ()):
                self.assertEqual(reference["referenceCategory"], "PACKAGE-MANAGER")
                self.assertRegex(reference["referenceLocator"], "^pkg:[a-z]+/")
            for checksum in package.get("checksums", ()):
                self.assertRegex(checksum["checksumValue"], "^[0-9a-f]+$")
            if "packageFileName" in package:
                self.assertEqual(package["licenseDeclared"], "MIT")
                self.assertIn("Copyright", package["copyrightText"])
                found[package["packageFileName"]] = package["checksums"]
        described = {name: [{"algorithm": "SHA256", "checksumValue": digest}] for name, digest in sums.items()
                     if name.endswith(".tar.gz")}
        self.assertEqual(found, described)
        self.assertIn("commit " + head, [package.get("sourceInfo") for package in bill["packages"]])
        kinds = {"DESCRIBES", "GENERATED_FROM", "BUILD_TOOL_OF", "DYNAMIC_LINK", "STATIC_LINK", "DEPENDS_ON", "CONTAINS"}
        for relation in bill["relationships"]:
            self.assertIn(relation["relationshipType"], kinds)
            self.assertIn(relation["spdxElementId"], names | {"SPDXRef-DOCUMENT"})
            self.assertIn(relation["relatedSpdxElement"], names)

    def test_difference(self):
        edit("cmake/release/pack.sh", '    cp -R "$from/unity" "$to"\n', '    cp -R "$from/unity" "$to"; pwd -P >"$to/place"\n'
             '    echo "$source" >>"$to/place"\n')
        commit()
        run = release("--rehearse")
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertRegex(run.stderr, r"(?m)^release.sh: the two passes differ in: scarp-csharp-[0-9.]+tar\.gz$")
        self.assertFalse(os.path.exists(OUTPUT))
        kept = re.findall(r"(/\S*?/scarp-release[^/]*)/", run.stderr)
        self.assertTrue(kept, run.stderr)
        for folder in set(kept):
            if os.path.dirname(folder) != TEMPORARY:
                shutil.rmtree(folder)
        self.kept = [os.path.basename(folder) for folder in set(kept) if os.path.dirname(folder) == TEMPORARY]


def prepare():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    os.makedirs(REPOSITORY)
    os.makedirs(TEMPORARY)
    unwanted = shutil.ignore_patterns("*.png", "*.jpg", "*.svg", "__pycache__", "target", "node_modules", "mutants")
    for name in TREE:
        if os.path.isdir(os.path.join(SOURCE, name)):
            shutil.copytree(os.path.join(SOURCE, name), path(name), symlinks=True, ignore=unwanted)
        else:
            shutil.copy(os.path.join(SOURCE, name), path(name))
    # Lines that were added since the last release are frozen for the next one.
    with open(os.path.join(SOURCE, "tests", "golden.txt"), encoding="utf-8") as file:
        lines = [line for line in file if len(line.split()) == 2]
    with open(path("tests/golden.txt"), "w", encoding="utf-8") as file:
        file.writelines(lines)


TEMPORARY = os.path.join(SCRATCH, "temporary")
prepare()
ENVIRONMENT = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
ENVIRONMENT.update(PATH=links(os.path.join(SCRATCH, "programs")), CC=COMPILER, TMPDIR=TEMPORARY, JOBS="1", LC_ALL="C",
                   GIT_CONFIG_NOSYSTEM="1", GIT_CONFIG_GLOBAL="/dev/null",
                   GIT_AUTHOR_NAME="a", GIT_AUTHOR_EMAIL="a@example.org", GIT_AUTHOR_DATE=TIME,
                   GIT_COMMITTER_NAME="a", GIT_COMMITTER_EMAIL="a@example.org", GIT_COMMITTER_DATE=TIME)
unittest.main(argv=sys.argv[:1], verbosity=2)
