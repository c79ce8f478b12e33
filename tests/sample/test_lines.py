# SPDX-License-Identifier: MIT
"""What lines of CSV and text may look like, and what is said of those that may not."""
import common
from common import run, float32, npy, read_npy, Case, BLOCK


class Lines(Case):
    """What counts as a line, a field, a header row."""

    def setUp(self):
        super().setUp()
        self.expected = self.text("1.5 2.25\n-3.5 4.75\n")

    def check(self, data, *arguments, header=""):
        with self.subTest(data=data):
            self.assertEqual(self.text(data, *arguments), header + self.expected)

    def test_line_ends(self):
        for data in (b"1.5 2.25\n-3.5 4.75", b"1.5 2.25\r\n-3.5 4.75\r\n", b"1.5 2.25\r\n-3.5 4.75\r",
                     b"\n\n1.5 2.25\n \t \n\r\n-3.5 4.75\n\n\n", b"\xef\xbb\xbf1.5 2.25\n-3.5 4.75\n"):
            self.check(data)
            self.check(data.replace(b" 2", b",2").replace(b" 4", b",4"))

    def test_blanks(self):
        self.check("  1.5\t 2.25 \n\t-3.5    4.75\t\t\n")
        self.check(" 1.5\t, 2.25 \n\t-3.5 ,   4.75\t\t\n")

    def test_comments(self):
        self.check("# 1 2\n1.5 2.25\n#\n#3\n-3.5 4.75\n# end")
        self.check("#x,y,z\n\nx,y\n# 1,2,3\n1.5,2.25\n#\n-3.5,4.75\n", header="value\n")
        self.check("1.5 2.25\n#%s\n-3.5 4.75\n" % ("x" * 200000))
        self.check("#%s\n1.5 2.25\n-3.5 4.75\n" % ("x" * 70000))
        self.check(b"1.5 2.25\n# \0\n-3.5 4.75\n")

    def test_quotes(self):
        self.check('"1.5","2.25"\n"-3.5", "4.75" \n')
        self.check('1.5,2.25,"a, ""b"" c"\n-3.5,4.75,""\n', "--dims", "2")
        self.check('"x","y","the ""n"", north"\n1.5,2.25,\n-3.5," 4.75 ",""\n', header="value\n")

    def test_header(self):
        """Two fields that are no numbers at all; one that a point cannot have is malformed. What
        names mean, is in test_columns.py."""
        for header in ("x,y", '"x","y"', " X ,y"):
            self.check(header + "\n1.5,2.25\n-3.5,4.75\n", header="value\n")
        for header in ("longitude (deg),", ",y", "n/a,x", "1a,2b", "x y,z"):
            self.check_refused(header + "\n1.5,2.25\n", "--columns: standard input has no column")
        self.check("1.5,2.25\n-3.5,4.75\n")
        for first in ("x,1", ",1", "1a,2", "1,x", "nan,1", "inf,y", "0x10,y", "1e999,y", '"1","y"'):
            self.check_refused(first + "\n1.5,2.25\n", "standard input:1: ")
        self.check_refused("x,y\na,b\n1,2\n", "standard input:2: column 1: 'a'")
        self.check_refused("x y\n1 2\n", "standard input:1: column 1: 'x'")

    def test_line_numbers(self):
        """Every line counts, whatever it holds."""
        self.check_refused("\ufeff# a\r\n\r\nx,y\r\n1,2\r\n\r\n# b\r\n1,z\r\n",
                           "scarp: --input: standard input:7: column 2: 'z' is not",
                           output=b"value\n" + self.sample("1 2"))
        path = self.write("p.txt", b"1 2\n" * 9999 + b"1 q\n" + b"1 r\n")
        self.check_refused(b"", "%s:10000: column 2: 'q'" % path, arguments=("--input", path),
                           output=self.sample("1 2") * 9999)

    def test_long_lines(self):
        """65535 bytes are a line, one more is malformed, wherever blocks of input end."""
        longest = "1.5 2.25" + " " * (65535 - 8)
        self.check(longest + "\n-3.5 4.75\n")
        self.check(longest + "\r\n-3.5 4.75")
        for length in (65536, 65537, 131071, 131072, 131073, 400001):
            line = "1" * (length - 2) + " 2"
            self.check_refused(line + "\n1 2\n", "standard input:1: longer than 65535 bytes")
            self.check_refused("1 2\n" + line, "standard input:2: longer than 65535 bytes",
                               output=self.sample("1 2"))
            result = run("--skip-bad", data="1.5 2.25\n%s\n-3.5 4.75\n%s" % (line, line))
            self.assertEqual((result.returncode, result.stdout.decode()), (0, self.expected))
            self.assertIn(b"2 malformed lines", result.stderr)

    def test_many(self):
        """Lines of changing length, over many reads of the input."""
        points = [(i * 0.5, 10.0 ** (i % 17)) for i in range(30000)]
        lines = ["%r%s%r" % (x, " " * (i % 97), y) if i % 97 else "%r %r" % (x, y)
                 for i, (x, y) in enumerate(points)]
        self.assertEqual(self.sample("\n".join(lines)),
                         self.sample(npy(points), "--output-format", "text"))


class Delimiters(Case):
    """What separates columns, and what marks decimals: found where it is plain, and refused where not."""

    def setUp(self):
        super().setUp()
        self.expected = self.text("1.5 2.25\n-3.5 4.75\n")

    def check(self, data, *arguments, header="", commas=False):
        with self.subTest(data=data):
            expected = self.expected.replace(".", ",") if commas else self.expected
            self.assertEqual(self.text(data, *arguments), header + expected)

    def test_found(self):
        self.check("1.5;2.25\n-3.5;4.75\n")
        self.check("1.5\t2.25\n-3.5\t4.75\n")
        self.check("1,5;2,25\n-3,5;4,75\n", commas=True)
        self.check("1,5\t2,25\n-3,5\t4,75\n", commas=True)
        self.check("1,5 2,25\n-3,5  4,75\n", commas=True)
        self.check(" 1,5 ; 2,25 \r\n\t-3,5\t;\t4,75\r\n", commas=True)
        self.check('"1,5";"2,25"\n"-3,5";"4,75"\n', commas=True)
        self.check("1,5e0;22,5E-1\n-3,5;+4,75\n", commas=True)

    def test_header(self):
        for d in ";\t":
            self.check("x;y\n1.5;2.25\n-3.5;4.75\n".replace(";", d), header="value\n")
            self.check("x;y\n1,5;2,25\n-3,5;4,75\n".replace(";", d), header="value\n", commas=True)
            self.check("a name;Y;x\n;2,25;1,5\n;4,75;-3,5\n".replace(";", d), header="value\n",
                       commas=True)
            self.check("lon, deg;lat, deg\n1,5;2,25\n-3,5;4,75\n".replace(";", d), "--columns",
                       '"lon, deg","lat, deg"', header="value\n", commas=True)
            self.check('n;"a;b";"c\td"\n0;1.5;2.25\n0;-3.5;4.75\n'.replace(";", d), "--columns",
                       "2,3", header="value\n") if d == ";" else None
            self.check_refused("lon;lat\n1;2\n".replace(";", d),
                               "--columns: standard input has no columns x and y; choose from 'lon', 'lat'")

    def test_commas_stay(self):
        """What else is in the row of CSV"""
        self.check("1.5,2.25,a;b\n-3.5,4.75,c;d\n", "--dims", "2")
        self.check("1.5,2.25,a\tb\n-3.5,4.75,c\td\n", "--dims", "2")
        self.check('x,y,"a;b"\n1.5,2.25,0\n-3.5,4.75,0\n', header="value\n")
        self.check("x,y,a;b\n1.5,2.25,0\n-3.5,4.75,0\n", header="value\n")
        self.check("a;b,1.5,2.25\nc;d,-3.5,4.75\n", "--columns", "2,3")

    def test_given(self):
        for word, d in (("semicolon", ";"), (";", ";"), ("tab", "\t"), ("\t", "\t"), ("\\t", "\t"),
                        ("space", " "), (" ", " ")):
            self.check("1,5;2,25\n-3,5;4,75\n".replace(";", d), "--delimiter", word, commas=True)
        self.check("1.5,2.25\n-3.5,4.75\n", "--delimiter", "comma")
        self.check("1.5,2.25\n-3.5,4.75\n", "--delimiter", ",", "--input-format", "csv")
        self.check("1.5  2.25\n-3.5\t4.75\n", "--delimiter", "space", "--input-format", "text")
        self.check("1,5\t2,25\t\n-3,5\t4,75\t\n", "--delimiter", "tab", "--dims", "2", commas=True)
        self.check_refused("1,5;2,25\n", ":1: column 2: '5;2' is not", arguments=("--delimiter", "comma"))
        self.check("red x\t1.5\t2.25\na\t-3.5\t4.75\n", "--columns", "2,3")
        self.check("\t1.5\t2.25\n\t-3.5\t4.75\n", "--columns", "2,3")
        self.check_refused("red 5\t1.5\t2.5\n", "--delimiter: standard input:1 has tabs and blanks: ",
                           "which of them separates columns, tab or space?", arguments=("--columns", "2,3"))
        self.check_refused("1,2\n3;4,5\n", ":2: column 1: '3;4' is not a finite number (see --delimiter)",
                           output=self.sample("1,2\n"))
        self.check_refused("1.5\t\t2.25\n", ":1: column 2 is empty", arguments=(
            "--delimiter", "tab", "--dims", "2"))
        self.check_refused("1 2\n", ":1: 1 column, but", "(see --delimiter)", arguments=("--delimiter", "tab"))
        for words in (("comma", "--input-format", "text"), ("space", "--input-format", "csv"),
                      ("tab", "--input-format", "npy"), ("x",), ("",), ("commas",), (";;",)):
            self.check_refused("1 2\n", "--delimiter: ", arguments=("--delimiter", *words))
        self.check_refused(npy([(1, 2)]), "--delimiter: is for text, and standard input is .npy",
                           arguments=("--delimiter", "tab"))

    def test_not_plain(self):
        """The message has the row and what was found in it."""
        for row in ("a,b;c", "x,y;z", "1;a,b", "1,a;2", "a;1,5"):
            self.check_refused("# a comment\n" + row + "\n", "--delimiter: standard input:2 has commas and "
                               "semicolons: '%s'" % row)
        self.check_refused("1,5;2,5\n1;2\n1.5;2,5\n", "standard input:3: column 1: '1.5' has a decimal "
                           "point, and numbers before a comma",
                           output=self.sample("1,5;2,5\n1;2\n"))
        self.check_refused("1;2\n1.5;2,5\n", "standard input:2: column 2: '2,5' has a decimal comma, "
                           "and numbers before a point", output=self.sample("1;2\n"))
        self.check_refused("1;2\n1.234,5;2\n", ":2: column 1: '1.234,5' is not a finite number",
                           output=self.sample("1;2\n"))
        self.check_refused("1|2\n", "1 column, but a point has 2 or 3 (see --delimiter): '1|2'")
        for encoding in ("utf-16-le", "utf-16-be"):
            self.check_refused("\ufeffx;y\n1;2\n".encode(encoding), "standard input: is UTF-16")
        self.check_refused(npy([(1, 2)])[1:], "standard input:1: ")
        skipped = self.sample("1,5;2,5\n1.5;2.5\n-3,5;4\n", "--skip-bad",
                              error=b"scarp: --skip-bad: 1 malformed line of standard input was left out\n")
        self.assertEqual(skipped, self.sample("1,5;2,5\n-3,5;4\n"))

    def test_results(self):
        """They have the delimiter and the mark of the points; text has blanks."""
        value = self.text("1.5 2.25").strip()
        comma = value.replace(".", ",")
        for data, words, out in (
                ("x;y\n1,5;2,25\n", (), "x;y;value\n1,5;2,25;%s\n" % comma),
                ("x;y\n1.5;2.25\n", (), "x;y;value\n1.5;2.25;%s\n" % value),
                ("x\ty\n1,5\t2,25\n", (), "x\ty\tvalue\n1,5\t2,25\t%s\n" % comma),
                ("1,5 2,25\n", (), "1,5 2,25 %s\n" % comma),
                ("1,5 2,25\n", ("--output-format", "csv"), "x;y;value\n1,5;2,25;%s\n" % comma),
                ("1.5 2.25\n", ("--output-format", "csv"), "x,y,value\n1.5,2.25,%s\n" % value),
                ("x;y\n1,5;2,25\n", ("--output-format", "text"), "1,5 2,25 %s\n" % comma),
                ("x;y\n1.5;2.25\n", ("--output-format", "text"), "1.5 2.25 %s\n" % value)):
            self.assertEqual(self.text(data, "--keep", *words), out)
            self.assertEqual(self.text(out, "--dims", "2"), self.text(data, *words))  # and are read again
        self.sample("1,5;2,25\n", "--output", self.path("o.npy"))
        self.assertEqual(["%.9g" % n for n in read_npy(self.read("o.npy"))[2][0]], [value])


class Malformed(Case):
    """Lines that are no points."""

    def test_messages(self):
        for data, message in (
                ("1,2\n3\n", ":2: 1 column, but the first line has 2"),
                ("1,2\n3,4,5\n", ":2: 3 columns, but the first line has 2: '3,4,5'\n"),
                ("1,2,3\n3,4\n", ":2: 2 columns, but the first line has 3"),
                ("x,y\n1,2,3\n", ":2: 3 columns, but the first line has 2"),
                ("1 2\n3\n", ":2: 1 column, but the first line has 2"),
                ("1\n", ":1: 1 column, but a point has 2 or 3"),
                ("1 2 3 4\n", ":1: 4 columns, but a point has 2 or 3 (see --columns)"),
                ("x,y,c,d\n1,2,3\n", ":2: 3 columns, but the first line has 4"),
                ("1,2\n3,\n", ":2: column 2 is empty"),
                ("1,2\n,3\n", ":2: column 1 is empty"),
                ("1,2\n3, \n", ":2: column 2 is empty"),
                ('1,2\n3,""\n', ":2: column 2 is empty"),
                ('1,2\n3,"4\n', ":2: column 2 has a quote that is not closed"),
                ('1,2\n3,"4"5\n', ":2: column 2 goes on after its quotes"),
                ("1,2\n3,4 5\n", ":2: column 2: '4 5' is not a finite number"),
                ("1,2\n3,%s\n" % ("y" * 99), ":2: column 2: '%s' is not" % ("y" * 60)),
                ("1,2\n3,a\tb\x1bc\x7f\n", ":2: column 2: 'a?b?c?' is not"),
                (b"1,2\n3,4\0\n", ":2: holds a NUL byte"),
                (b"1,2\n\0\n", ":2: holds a NUL byte"),
                (b"x\0,\0y\0\n\0", ":1: holds a NUL byte")):
            with self.subTest(data=data):
                self.check_refused(data, "scarp: --input: standard input" + message,
                                   arguments=("--output", self.path("o.txt")))
        self.check_refused("1,2,3\n4\n", "standard input:2: 1 column, but --dims is 2",
                           arguments=("--dims", "2", "--output", self.path("o.txt")))
        self.assertEqual(self.files(), [])

    def test_earlier_points(self):
        """Standard output has got the points before the malformed line; a file none."""
        for count in (1, 100, BLOCK, 2 * BLOCK + 5):
            data = b"1 2\n" * count + b"bad\n" + b"1 2\n"
            self.check_refused(data, ":%d: " % (count + 1), output=self.sample("1 2") * count)
            self.check_refused(data, arguments=("--output", self.path("o.txt")))
            self.assertEqual(self.files(), [])

    def test_skip_bad(self):
        data = "junk\n1.5 2.25\n7\n1 2 3\n\n# c\nnan 1\n-3.5 4.75\nx"
        message = b"scarp: --skip-bad: 5 malformed lines of standard input were left out\n"
        expected = self.sample("1.5 2.25\n-3.5 4.75\n")
        self.assertEqual(self.sample(data, "--skip-bad", error=message), expected)
        self.assertEqual(self.sample(data, "--skip-bad", "--quiet"), expected)
        self.assertEqual(self.sample("1.5 2.25\n-3.5 4.75\n", "--skip-bad"), expected)
        path = self.write("one.txt", b"1 2\n3\n")
        self.assertEqual(self.sample(b"", "--skip-bad", "--input", path,
                                     error=b"scarp: --skip-bad: 1 malformed line of %s was left "
                                           b"out\n" % path.encode()), self.sample("1 2"))
        self.assertEqual(self.sample(b"junk\n", "--skip-bad", error=message.replace(
            b"5 malformed lines", b"1 malformed line").replace(b"were", b"was")), b"")

    def test_skip_many(self):
        """Also where whole blocks are malformed."""
        data = "bad bad\n" * 50000 + "1.5 2.25\n" + "bad bad\n" * 50000
        result = run("--skip-bad", data=data)
        self.assertEqual((result.returncode, result.stdout), (0, self.sample("1.5 2.25")))
        self.assertIn(b"100000 malformed lines", result.stderr)


class Columns(Case):
    """Columns behind the coordinates: --dims and --keep."""

    def test_dims(self):
        value2, value3 = self.text("1.5 2.25"), self.text("1.5 2.25 3.5")
        for data in ("1.5 2.25 3.5 name", "1.5,2.25,3.5,name", "x,y,z,d\n1.5,2.25,3.5,name"):
            self.assertTrue(self.text(data, "--dims", "2").endswith(value2))
            self.assertTrue(self.text(data, "--dims", "3").endswith(value3))
        self.assertEqual(self.text("1.5 2.25 3.5", "--dims", "2"), value2)
        self.assertEqual(self.text("1.5 2.25\n1.5 2.25 a b\n1.5 2.25 c", "--dims", "2"),
                         value2 * 3)  # what is ignored need not be regular
        wide = [(1.5, 2.25, 3.5, 9, 9), (1.5, 2.25, 3.5, 8, 8)]
        for descr in ("<f4", ">f8"):
            for dims, value in (("2", value2), ("3", value3)):
                self.assertEqual(self.text(npy(wide, descr), "--dims", dims, "--output-format",
                                           "text"), value * 2)

    def test_keep_csv(self):
        """The line as it is, quotes and blanks included."""
        value = self.text("1.50 2")[:-1]
        self.assertEqual(self.text('1.50 , "2"\n', "--keep"), '1.50 , "2",%s\n' % value)
        self.assertEqual(self.text('x, "y, m",n\r\n1.50,2,"a ""b"", c"\r\n', "--keep", "--columns",
                                   'x,"y, m"'),
                         'x, "y, m",n,value\n1.50,2,"a ""b"", c",%s\n' % value)
        self.assertEqual(self.text('1.50,2,n\n', "--keep", "--dims", "2"), "1.50,2,n,%s\n" % value)

    def test_keep_text(self):
        value = self.text("1.50 2")[:-1]
        self.assertEqual(self.text("  1.50\t2  é \n", "--keep", "--dims", "2"),
                         "1.50 2 é %s\n" % value)

    def test_keep_across(self):
        value = self.text("1.50 2")[:-1]
        self.assertEqual(self.text('1.50 2 a,"b "c" 5\n', "--keep", "--dims", "2",
                                   "--input-format", "text", "--output-format", "csv"),
                         'x,y,column3,column4,column5,value\n1.50,2,"a,""b","""c""",5,%s\n' % value)
        self.assertEqual(self.text('x,y,n\n 1.50,"2","a""b"\n', "--keep", "--dims", "2",
                                   "--output-format", "text"), '1.50 2 a"b %s\n' % value)
        for field in ("", '""', "a b", '"a\tb"'):
            self.check_refused("1.5,2,%s\n" % field, "standard input:1: column 3: ", "of text",
                               arguments=("--keep", "--dims", "2", "--output-format", "text"))

    def test_keep_is_regular(self):
        """Results are in the same column on every line."""
        for data in ("1 2 a\n1 2\n", "1 2 a\n1 2 a b\n", "x,y\n1,2,3\n"):
            self.check_refused(data, ":2: ", "but the first line has",
                               arguments=("--keep", "--dims", "2", "--output", self.path("o")))

    def test_keep_npy(self):
        """Only coordinates, from and to .npy."""
        point = (1.5, 2.25, 7.0)
        value = float(self.text("1.5 2.25"))
        for data in (npy([point]), npy([point], ">f4"), "1.5,2.25,seven\n", "1.5 2.25 7 8\n"):
            self.sample(data, "--keep", "--dims", "2", "--output", self.path("o.npy"))
            descr, _, rows = read_npy(self.read("o.npy"))
            self.assertEqual((descr, [[float32(n) for n in row] for row in rows]),
                             ("<f8", [[1.5, 2.25, float32(value)]]))
        self.assertEqual(self.text(npy([point]), "--keep", "--dims", "2", "--output-format", "csv"),
                         "x,y,value\n1.5,2.25,%.9g\n" % value)

    def test_long_kept(self):
        """Kept lines as long as lines can be, through every buffer."""
        lines = ['%d,2,"%s"' % (i, '""' * n) for i, n in enumerate((10, 32000, 1, 32760, 5000))]
        out = self.text("\n".join(lines), "--keep", "--dims", "2")
        self.assertEqual([line.rsplit(",", 1)[0] for line in out.splitlines()], lines)
        out = self.text("\n".join(lines), "--keep", "--dims", "2", "--output-format", "text")
        self.assertEqual([len(line.split()[2]) for line in out.splitlines()],
                         [10, 32000, 1, 32760, 5000])


common.main(globals())
