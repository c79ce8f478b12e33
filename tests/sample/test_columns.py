# SPDX-License-Identifier: MIT
"""Which columns are the coordinates: the names of a header row, --columns, --dims."""
import itertools
import os
import re
import shutil
import subprocess
import unittest

import common
from common import float32, npy, read_npy, Case, KINDS

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


class Coordinates(Case):
    """Points whose results are known: (1.5, 2.25) and (1.5, 2.25, 3.5)."""

    def setUp(self):
        super().setUp()
        self.value2 = self.text("1.5 2.25")
        self.value3 = self.text("1.5 2.25 3.5")
        self.assertEqual(len({self.value2, self.value3, self.text("2.25 1.5")}), 3)

    def check2(self, data, *arguments):
        with self.subTest(data=data, arguments=arguments):
            self.assertEqual(self.text(data, *arguments, "--output-format", "text"), self.value2)

    def check3(self, data, *arguments):
        with self.subTest(data=data, arguments=arguments):
            self.assertEqual(self.text(data, *arguments, "--output-format", "text"), self.value3)

    def check_error(self, data, error, *arguments):
        """One line, which is `error`, and no file."""
        with self.subTest(data=data, arguments=arguments):
            self.check_refused(data, "scarp: %s\n" % error,
                               arguments=("--output", self.path("o.csv")) + arguments)
            self.check_refused(data, arguments=("--skip-bad", "--keep") + arguments)
            self.assertEqual(self.files(), [])


class Header(Coordinates):
    """Columns named x, y and z are the coordinates, wherever they are."""

    def test_names(self):
        for data in ("x,y\n1.5,2.25\n", "id,x,y\n7,1.5,2.25\n", "id,y,x\n7,2.25,1.5\n",
                     "y,name,x\n2.25,oak,1.5\n", "a,b,c,d,x,y\n1,2,3,4,1.5,2.25\n",
                     ",x,y\n0,1.5,2.25\n", "id,X,Y\n7,1.5,2.25\n", "id, x\t, y \r\n7,1.5,2.25\r\n",
                     '"id","x"," Y "\n7,1.5,2.25\n', '"a, b",x,"the ""y""",y\n1,1.5,9,2.25\n',
                     "\ufeffx,id,y\n1.5,7,2.25\n", "# points\n\nid,x,y\n7,1.5,2.25\n",
                     "xx,yy,x,y\n1,2,1.5,2.25", "y,x\n2.25,1.5\n", "id,2020,x,y\n7,8,1.5,2.25\n",
                     "1990,2000,x,y\n7,8,1.5,2.25\n", '7,"Y",X\n7,2.25,1.5\n'):
            self.check2(data)
            self.check2(data, "--dims", "2")

    def test_z(self):
        for data in ("x,y,z\n1.5,2.25,3.5\n", "z,y,x\n3.5,2.25,1.5\n", "x,y,id,Z\n1.5,2.25,7,3.5\n",
                     'id,"z",x,y,n\n7,3.5,1.5,2.25,oak\n'):
            self.check3(data)
            self.check3(data, "--dims", "3")
            self.check2(data, "--dims", "2")

    def test_no_z(self):
        self.check2("x,n,y\n1.5,oak,2.25\n", "--dims", "2")
        self.check_error("x,n,y\n1.5,oak,2.25\n", "--dims: standard input has no column z; "
                         "--columns chooses from 'x', 'n', 'y'", "--dims", "3")

    def test_no_x_and_y(self):
        """Nothing is guessed from names that say something else, however many columns there are."""
        for header, missing in (("lon,lat", "columns x and y"), ("a,b,c", "columns x and y"),
                                ("x,lat", "column y"), ("n,y,z", "column x"),
                                ("oak,tall,1.5,2.25", "columns x and y"),
                                ("x y,xy", "columns x and y"), ("x1,y1", "columns x and y"),
                                (",", "columns x and y")):
            names = ", ".join("'%s'" % name for name in header.split(","))
            row = "\n" + ",".join("7" for _ in header.split(",")) + "\n"
            for dims in ((), ("--dims", "2"), ("--dims", "3")):
                self.check_error(header + row, "--columns: standard input has no %s; choose from %s"
                                 % (missing, names), *dims)
            self.check_error(header + "\n", "--columns: standard input has no %s; choose from %s"
                             % (missing, names))
        path = self.write("p.csv", b"lon,lat\n1,2\n")
        self.check_refused(b"", "--columns: %s has no columns x and y" % path,
                           arguments=("--input", path))

    def test_shown_names(self):
        """As they are meant: without quotes, on one line, as many as there is room for."""
        self.check_error('"a, b" , the ""b"",\x1b[1m"c",\xe9\n', "--columns: standard input has no "
                         "columns x and y; choose from 'a, b', 'the \"\"b\"\"', '?[1m\"c\"', "
                         "'\xe9'")
        self.check_error('a,"the ""b"""\n', "--columns: standard input has no columns x and y; "
                         "choose from 'a', 'the \"b\"'")
        header = ",".join("name%d" % i for i in range(1000))
        result = common.run(data=header)
        self.assertRegex(result.stderr.decode(), r"\Ascarp: --columns: .*'name0', 'name1', .*"
                         r"'name(\d+)' and \d+ more\n\Z")
        last, more = re.search(r"'name(\d+)' and (\d+)", result.stderr.decode()).groups()
        self.assertEqual(int(last) + 1 + int(more), 1000)
        self.assertGreater(int(last), 40)
        for length in range(50, 70):
            long = "\xe9" * length + "b" * 60000
            error = common.run(data="a,b" + long).stderr.decode()  # no half of a character
            self.assertRegex(error, r"\Ascarp: [^\n]{50,}\n\Z")
            self.assertLess(len(error), 200)

    def test_twice(self):
        for header, name in (("x,x,y", "x"), ("x,y,X", "x"), ("id,y,x,y", "y"), ("z,x,y,Z", "z"),
                             ('x,"x",y', "x")):
            names = ", ".join("'%s'" % n.strip('"') for n in header.split(","))
            row = "\n" + ",".join("7" for _ in header.split(",")) + "\n"
            self.check_error(header + row, "--columns: standard input has 2 columns '%s'; choose "
                             "by number, from 1 on: %s" % (name, names))
        self.check2("z,x,y,z\n1,1.5,2.25,2\n", "--dims", "2")
        self.check2("x,X,y\n9,1.5,2.25\n", "--columns", "2,3")

    def test_others_are_ignored(self):
        """Whatever they hold, unless they break the line."""
        self.check2('id,x,y,note\n,1.5,2.25,\n')
        self.check2('id,x,y,note\nnan,1.5,2.25,"a, ""b"""\n')
        self.check_refused('id,x,y,note\n7,1.5,2.25,"a"b\n', ":2: column 4 goes on after")
        self.check_refused('id,x,y\n7,1.5,z\n', ":2: column 3: 'z' is not a finite number")
        self.check_refused('y,id,x\n7,1.5,\n', ":2: column 3 is empty")

    def test_kept(self):
        value = self.value2.strip()
        data = ' "id", X,n,"y"\n7, 1.50,"a, b", 2.25\n'
        self.assertEqual(self.text(data, "--keep"),
                         ' "id", X,n,"y",value\n7, 1.50,"a, b", 2.25,%s\n' % value)
        self.assertEqual(self.text("id,x,y\n7,1.50,2.25\n", "--keep", "--output-format", "text"),
                         "7 1.50 2.25 %s\n" % value)
        self.sample(data, "--keep", "--output", self.path("o.npy"))
        self.assertEqual(read_npy(self.read("o.npy")),
                         ("<f8", 3, [[1.5, 2.25, float32(float(value))]]))

    def test_regular(self):
        """Lines with another number of columns than names: something may have moved."""
        for arguments in ((), ("--dims", "2"), ("--columns", "x,y"), ("--columns", "2,3")):
            for row in ("Smith, 5,1.5,2.25", "7,1.5", "7,1.5,2.25,"):
                self.check_refused("id,x,y\n%s\n" % row, ":2: ", "but the first line has 3: '",
                                   arguments=arguments)

    def test_no_points(self):
        for header, columns in (("id,x,y", 3), ("x,y,z", 4), ("x,y,n", 3)):
            self.assertEqual(self.text(header + "\n", "--keep"), header + ",value\n")
            self.sample(header, "--gradient", "--output", self.path("o.npy"))
            self.assertEqual(read_npy(self.read("o.npy")), ("<f4", columns, []))

    def test_broken(self):
        for header, problem in (('x,"y', "column 2 has a quote that is not closed"),
                                ('x,y,"n"z', "column 3 goes on after its quotes")):
            self.check_error(header + "\n1,2\n", "--input: standard input: the header row's " +
                             problem)


class Chosen(Coordinates):
    """--columns: names of a header row, or numbers."""

    def test_names(self):
        for data in ("lon,lat\n1.5,2.25\n", "id,lon,lat\n7,1.5,2.25\n", "lat,id,lon\n2.25,7,1.5\n",
                     "LON,n,Lat\n1.5,7,2.25\n", 'x,y,"lon", lat \n8,9,1.5,2.25\n',
                     "1990,1991,lon,lat\n8,9,1.5,2.25\n"):
            self.check2(data, "--columns", "lon,lat")
            self.check2(data, "--columns=Lon, LAT ", "--dims", "2")
            self.check2(data, "--columns", '"lon","lat"')
        self.check2("x,y,z\n8,2.25,1.5\n", "--columns", "z,y")
        self.check3("id,e,n,h,x,y\n7,1.5,2.25,3.5,8,9\n", "--columns", "e,n,h")
        self.check3("id,e,n,h,x,y\n7,1.5,2.25,3.5,8,9\n", "--columns", "e,n,h", "--dims", "3")
        self.check2("lon,lat,lat.1\n1.5,2.25,9\n", "--columns", "lon,lat")
        self.check2("\xe9,y\n1.5,2.25\n", "--columns", "\xe9,y")
        self.check2("x,1,2\n1.5,2.25,9\n", "--columns", "x,1")  # not two numbers

    def test_names_in_quotes(self):
        header = '"lon, east","the ""lat""",n\n1.5,2.25,3.5\n'
        self.check2(header, "--columns", '"lon, east","the ""lat"""')
        self.check3(header, "--columns", '"lon, east","the ""LAT""",n')
        self.check2('"a b",c d\n1.5,2.25\n', "--columns", 'a b,"c d"')

    def test_unknown_names(self):
        there = "choose from 'id', 'lon', 'lat'"
        for columns, name in (("lon,latt", "latt"), ("x,y", "x"), ("lon,lat,h", "h"),
                              ("lon,2", "2"), ('"lon,lat",lat', "lon,lat"), ("lo,la", "lo"),
                              ("-1,lat", "-1")):
            self.check_error("id,lon,lat\n7,1,2\n", "--columns: standard input has no column '%s'; "
                             "%s" % (name, there), "--columns", columns)
        self.check_error("1,2,3\n4,5,6\n", "--columns: standard input has no column 'x'; choose "
                         "from '1', '2', '3'", "--columns", "x,y")
        self.check_error("lon,lat,LAT\n1,2,3\n", "--columns: standard input has 2 columns 'Lat'; "
                         "choose by number, from 1 on: 'lon', 'lat', 'LAT'", "--columns", "lon,Lat")

    def test_numbers(self):
        for data in ("7,1.5,2.25\n", "id,x,y\n7,1.5,2.25\n", "id,lon,lat\n7,1.5,2.25\n",
                     "7 1.5 2.25", npy([(7, 1.5, 2.25)]), npy([(7, 1.5, 2.25, 9)], ">f4"),
                     "oak,1.5,2.25,tall,9", "id,1 m,2 m\noak,1.5,2.25"):
            self.check2(data, "--columns", "2,3")
            self.check2(data, "--columns=02,3", "--dims", "2")
        self.check2("oak,tall,1.5,2.25\n", "--columns", "3,4")  # two words do not make a header row
        self.check2("name,kind,lon,lat\noak,tall,1.5,2.25\n", "--columns", "3,4")
        for data in ("3.5,9,2.25,1.5\n", "3.5 9 2.25 1.5", npy([(3.5, 9, 2.25, 1.5)])):
            self.check3(data, "--columns", "4,3,1")
            self.check2(data, "--columns", "4,3")
        wide = ["0"] * 20000
        wide[11110], wide[19999] = "1.5", "2.25"
        self.check2(",".join(wide), "--columns", "11111,20000")

    def test_many_rows(self):
        """Of .npy, over many reads of the input."""
        rows = [(i, i * 0.5, -i, i * 0.25) for i in range(30000)]
        chosen = npy([(row[3], row[1]) for row in rows])
        for descr in ("<f8", ">f4"):
            self.assertEqual(self.sample(npy(rows, descr), "--columns", "4,2"), self.sample(chosen))

    def test_unknown_numbers(self):
        for columns, number in (("3,4", 4), ("4,3", 4), ("1,2,65536", 65536)):
            self.check_error("id,x,y\n7,1,2\n", "--columns: standard input has no column %d; "
                             "choose from 1 to 3: 'id', 'x', 'y'" % number, "--columns", columns)
            self.check_refused("7,1,2\n", "standard input:1: 3 columns, but --columns takes column "
                               "%d: '7,1,2'" % number, arguments=("--columns", columns))
            self.check_refused("7 1 2\n", "standard input:1: 3 columns, but --columns takes column "
                               "%d: '7 1 2'" % number, arguments=("--columns", columns))
            self.check_error(npy([(7, 1, 2)]), "--columns: standard input has no column %d; choose "
                             "from 1 to 3" % number, "--columns", columns)

    def test_names_where_there_are_none(self):
        for data in ("7 1 2\n", "id x y\n7 1 2\n", npy([(7, 1, 2)])):
            self.check_error(data, "--columns: standard input has no column names, and so no "
                             "'x'; choose from 1 to 3", "--columns", "x,y")
        for data in (b"x,y\0\n1,2\n", b"x" * 70000 + b",y\n1,2\n", b"x\0 y\n"):
            self.check_error(data, "--columns: the header row of standard input is longer than "
                             "65535 bytes or holds a NUL byte", "--columns", "x,y")

    def test_dims_disagree(self):
        """Before anything is read."""
        for columns, dims in (("x,y", "3"), ("x,y,z", "2"), ("1,2", "3"), ("1,2,3", "2")):
            result = common.run("--columns", columns, "--dims", dims, "--input", self.path("none"))
            self.assertEqual((result.returncode, result.stdout), (2, b""))
            self.assertEqual(result.stderr.decode(), "scarp: --columns: names %d columns, but "
                             "--dims is %s\n" % (columns.count(",") + 1, dims))

    def test_bad_lists(self):
        for word in ("x", "x,", ",x", "x,,y", "1,2,3,4", "x,x", "x,y,X", '"x",x', "1,1", "1,01",
                     "1,2,01", "0,1", "1,65537", "1,99999999999999999999", "", " ", '"x,y', '"x"y,z',
                     '"","x"', ","):
            result = common.run("--columns=" + word, "--input", self.path("none"))
            self.assertEqual((result.returncode, result.stdout), (2, b""))
            self.assertEqual(result.stderr.decode(), "scarp: --columns: '%s' is not 2 or 3 "
                             "different columns with commas between: names of the header row, or "
                             "numbers from 1 to 65536\n" % word)

    def test_kept(self):
        value = self.value2.strip()
        self.assertEqual(self.text('id,lon,"lat"\n7,1.50,2.25\n', "--columns", "lon,lat", "--keep"),
                         'id,lon,"lat",value\n7,1.50,2.25,%s\n' % value)
        self.assertEqual(self.text("7,2.25,1.5\n", "--columns", "3,2", "--keep"),
                         "7,2.25,1.5,%s\n" % value)
        self.assertEqual(self.text("7 2.25 1.5 a\n", "--columns", "3,2", "--keep",
                                   "--output-format", "csv"),
                         "column1,y,x,column4,value\n7,2.25,1.5,a,%s\n" % value)
        for columns, names in (("3,2", "column1,y,x"), ("lon,lat", "x,y")):
            self.assertEqual(self.text("", "--columns", columns, "--keep", "--output-format", "csv"),
                             names + ",value\n")
        for data in ("7,2.25,1.5\n", "7 2.25 1.5", "id,a,b\n7,2.25,1.5", npy([(7, 2.25, 1.5)])):
            self.sample(data, "--columns", "3,2", "--keep", "--output", self.path("o.npy"))
            self.assertEqual(read_npy(self.read("o.npy")),
                             ("<f8", 3, [[1.5, 2.25, float32(float(value))]]))
        self.assertEqual(self.text(npy([(7, 2.25, 1.5)]), "--columns", "3,2", "--keep",
                                   "--output-format", "csv"), "x,y,value\n1.5,2.25,%s\n" % value)

    def test_ragged(self):
        """Without a header row, what is behind the columns need not be regular."""
        data = "a 1.5 2.25\nb 1.5 2.25 some words\nc 1.5 2.25 x\n"
        for data in (data, data.replace(" ", ",")):
            self.assertEqual(self.text(data, "--columns", "2,3"), self.value2 * 3)
            self.check_refused(data, ":2: ", "but the first line has 3",
                               arguments=("--columns", "2,3", "--keep", "--output", self.path("o")))
            self.assertEqual(self.text(data + "d\n", "--columns", "2,3", "--skip-bad", "--quiet"),
                             self.value2 * 3)

    def test_no_points(self):
        for kind, columns in itertools.product(KINDS[:2], ("lon,lat", "1,2")):
            self.assertEqual(self.text("", "--columns", columns, "--input-format", kind,
                                       "--output-format", "text"), "")
        self.sample("", "--columns", "a,b,c", "--gradient", "--output", self.path("o.npy"))
        self.assertEqual(read_npy(self.read("o.npy")), ("<f4", 4, []))
        self.assertEqual(self.text("lon,lat,n\n", "--columns", "lat,lon", "--keep"),
                         "lon,lat,n,value\n")


class Readme(Case):
    """The manual's examples of `scarp sample` print what it says."""

    @unittest.skipUnless(shutil.which("bash"), "needs bash")
    def test_examples(self):
        with open(os.path.join(ROOT, "src", "cli", "README.md"), encoding="utf-8") as file:
            fences = re.findall(r"(?ms)^```sh\n(.*?)^```$", file.read())
        example = re.compile(r"(?m)^\$ (.*\| scarp sample .*)\n((?:[^$\n].*\n)+)")
        examples = [found for fence in fences for found in example.findall(fence)]
        self.assertGreaterEqual(len(examples), 2)
        self.assertTrue(any("--columns" in command for command, _ in examples), examples)
        for command, printed in examples:
            script = 'scarp() { "${program[@]}" "$@"; }; program=("$@"); ' + command
            result = subprocess.run(["bash", "-c", script, "bash"] + common.PROGRAM,
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual((result.stdout.decode(), result.stderr), (printed, b""))


common.main(globals())
