// SPDX-License-Identifier: MIT
//! Links the C library, or compiles it. In this order:
//!
//! 1. `SCARP_LIB_DIR` in the environment: the folder of a library that was built before
//! 2. the library of the system, if pkg-config knows one of this version
//! 3. the library is compiled, by gcc or clang, and linked statically
//!
//! `SCARP_BUILD=system` refuses 3, `SCARP_BUILD=source` goes to 3 at once. The sources are the single
//! file in `c/`, as the package has it, or in scarp's own tree all files of the library.
//!
//! The compiler is `CC_<target>`, `TARGET_CC`, `CC`, or the usual one of the target; the archiver
//! likewise with `AR`. `CFLAGS_<target>`, `TARGET_CFLAGS`, `CFLAGS` come before the crate's own flags, which
//! keep the bits: `CFLAGS=-DSCARP_AVX512=0` leaves out a kernel set.
use std::collections::VecDeque;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{exit, Command, Stdio};
use std::thread;

fn main() {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    write_presets(&here);
    let choice = variable("SCARP_BUILD");
    match choice.as_deref() {
        None | Some("source") | Some("system") => (),
        Some(other) => fail(&format!("SCARP_BUILD is source or system, not {}", other)),
    }
    if choice.as_deref() != Some("source") {
        if let Some(folder) = variable("SCARP_LIB_DIR") {
            link_folder(Path::new(&folder));
            return;
        }
        if link_system() {
            return;
        }
        if choice.is_some() {
            fail("SCARP_BUILD=system, but pkg-config knows no scarp of this version");
        }
    }
    compile(&here);
}

fn fail(message: &str) -> ! {
    eprintln!("error: scarp: {}", message);
    exit(1)
}

/// A variable of the environment that is not empty. The build script runs again if it changes.
fn variable(name: &str) -> Option<String> {
    println!("cargo:rerun-if-env-changed={}", name);
    env::var(name).ok().filter(|value| !value.is_empty())
}

/// A variable by which compilers are told: for this target, for targets, or for all
fn variable_of_target(name: &str) -> Option<String> {
    let target = env::var("TARGET").unwrap();
    let kind = if is_cross() { "TARGET" } else { "HOST" };
    variable(&format!("{}_{}", name, target))
        .or_else(|| variable(&format!("{}_{}", name, target.replace('-', "_"))))
        .or_else(|| variable(&format!("{}_{}", kind, name)))
        .or_else(|| variable(name))
}

fn is_cross() -> bool {
    env::var("TARGET") != env::var("HOST")
}

/// Something of the target, as CARGO_CFG_ has it
fn target_is(what: &str, value: &str) -> bool {
    env::var(format!("CARGO_CFG_TARGET_{}", what)).map_or(false, |is| is == value)
}

/// Names and texts of the presets, which lie beside this file, or in the tree of scarp
fn write_presets(here: &Path) {
    let places = [here.join("presets"), here.join("../../cli/presets")];
    let folder = match places.iter().find(|folder| folder.is_dir()) {
        Some(folder) => folder,
        None => fail("there are no presets beside build.rs"),
    };
    println!("cargo:rerun-if-changed={}", folder.display());
    let mut text = String::from("const PRESETS: &[(&str, &str)] = &[\n");
    for path in files(folder, "recipe") {
        let name = path.file_stem().unwrap().to_str().unwrap();
        text += &format!("    ({:?}, include_str!({:?})),\n", name, path.to_str().unwrap());
    }
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    fs::write(out.join("presets.rs"), text + "];\n").expect("presets.rs cannot be written");
}

/// The files of a folder whose names end so, sorted
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let listed =
        fs::read_dir(folder).unwrap_or_else(|e| fail(&format!("{}: {}", folder.display(), e)));
    let mut paths: Vec<_> = listed
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().map_or(false, |is| is == extension))
        .collect();
    paths.sort();
    paths
}

// A library that is there

fn link_folder(folder: &Path) {
    let shared = ["libscarp.so", "libscarp.dylib", "libscarp.dll.a", "scarp.lib", "libscarp.dll"];
    let is_there = |name: &str| folder.join(name).is_file();
    if shared.iter().any(|name| is_there(name)) {
        println!("cargo:rustc-link-lib=dylib=scarp");
    } else if is_there("libscarp.a") {
        // It becomes a part of the crate, which has to be built again with another one.
        println!("cargo:rerun-if-changed={}", folder.join("libscarp.a").display());
        println!("cargo:rustc-link-lib=static=scarp");
        link_mathematics();
    } else {
        fail(&format!("SCARP_LIB_DIR={}: there is no library scarp", folder.display()));
    }
    println!("cargo:rustc-link-search=native={}", folder.display());
}

/// Asks pkg-config for a library that serves this version: of the same major version, and while
/// that is 0, of the same minor one.
fn link_system() -> bool {
    if is_cross() && variable("PKG_CONFIG_ALLOW_CROSS").is_none() {
        return false;
    }
    let program = variable("PKG_CONFIG").unwrap_or_else(|| "pkg-config".to_owned());
    for name in ["PKG_CONFIG_PATH", "PKG_CONFIG_LIBDIR", "PKG_CONFIG_SYSROOT_DIR"] {
        variable(name);
    }
    let number = |name| env::var(name).unwrap().parse::<u32>().unwrap();
    let (major, minor) = (number("CARGO_PKG_VERSION_MAJOR"), number("CARGO_PKG_VERSION_MINOR"));
    let least = format!("scarp >= {}", env::var("CARGO_PKG_VERSION").unwrap());
    let below = if major == 0 {
        format!("scarp < 0.{}", minor + 1)
    } else {
        format!("scarp < {}", major + 1)
    };
    let exists = Command::new(&program).args(["--exists", &least, &below]).status();
    if !exists.map_or(false, |status| status.success()) {
        return false;
    }
    let told = match Command::new(&program).args(["--libs", "scarp"]).output() {
        Ok(told) if told.status.success() => String::from_utf8_lossy(&told.stdout).into_owned(),
        _ => return false,
    };
    for word in told.split_whitespace() {
        if let Some(folder) = word.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={}", folder);
        } else if let Some(library) = word.strip_prefix("-l") {
            println!("cargo:rustc-link-lib=dylib={}", library);
        }
    }
    true
}

fn link_mathematics() {
    if !target_is("OS", "windows") {
        println!("cargo:rustc-link-lib=m");
    }
}

// Compiling

/// A file, and the flags that it has beside those of all files
type Job = (PathBuf, Vec<&'static str>);

fn compile(here: &Path) {
    if target_is("ENV", "msvc") {
        fail("cl cannot compile the library: build it with CMake, and set SCARP_LIB_DIR");
    }
    let single = here.join("c");
    let tree = here.join("../../..");
    let (jobs, header) = if single.join("scarp_single.c").is_file() {
        (vec![(single.join("scarp_single.c"), vec!["-O2"])], single)
    } else if tree.join("include/scarp.h").is_file() {
        (jobs_of_tree(&tree.join("src")), tree.join("include"))
    } else {
        fail("there is neither c/scarp_single.c nor the tree of scarp")
    };
    println!("cargo:rerun-if-changed={}", header.display());
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    let compiler = find_compiler();
    let objects = compile_all(&compiler, jobs, &header, &out);
    archive(&compiler, &objects, &out.join("libscarp.a"));
    println!("cargo:rustc-link-search=native={}", out.display());
    println!("cargo:rustc-link-lib=static=scarp");
    link_mathematics();
}

/// All C files of the library, in the rooms that it has; kernels come first, which take longest.
fn jobs_of_tree(src: &Path) -> Vec<Job> {
    let mut jobs = Vec::new();
    for room in ["simd", "scalar", "calls", "recipe", "plan", "dispatch"] {
        println!("cargo:rerun-if-changed={}", src.join(room).display());
        for path in files(&src.join(room), "c") {
            let is_hot = room == "simd" || path.ends_with("calls/samples.c");
            jobs.push((path, vec![if is_hot { "-O3" } else { "-O2" }]));
        }
    }
    for room in ["kernel", "formulas"] {
        println!("cargo:rerun-if-changed={}", src.join(room).display());
    }
    jobs
}

/// The flags of every file: C11, and what keeps the bits, behind those of the environment
fn flags() -> Vec<String> {
    let mut flags: Vec<String> = variable_of_target("CFLAGS")
        .unwrap_or_default()
        .split_whitespace()
        .map(str::to_owned)
        .collect();
    let mut add = |flag: &str| flags.push(flag.to_owned());
    if !target_is("OS", "windows") {
        add("-fPIC");
    }
    if target_is("ARCH", "x86") {
        add("-msse2");
        add("-mfpmath=sse");
    }
    if target_is("ARCH", "s390x") {
        add("-fexcess-precision=fast");
    }
    for flag in ["-std=c11", "-fvisibility=hidden", "-fno-fast-math", "-ffp-contract=off", "-w"] {
        add(flag);
    }
    flags
}

/// A command in words: a program, and what comes first of its arguments
type Words = Vec<String>;

fn works(words: &Words) -> bool {
    let tried = Command::new(&words[0])
        .args(&words[1..])
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    tried.map_or(false, |status| status.success())
}

fn words(text: &str) -> Words {
    text.split_whitespace().map(str::to_owned).collect()
}

/// What tools of GNU for the target begin with, as in aarch64-linux-gnu-gcc
fn prefix() -> String {
    let target = env::var("TARGET").unwrap();
    let arch = target.split('-').next().unwrap_or("");
    if target.ends_with("-pc-windows-gnu") {
        return format!("{}-w64-mingw32-", arch);
    }
    let arch = match arch {
        "armv7" | "thumbv7neon" => "arm",
        "riscv64gc" => "riscv64",
        arch => arch,
    };
    let rest: Vec<_> = target.split('-').skip(1).filter(|part| *part != "unknown").collect();
    format!("{}-{}-", arch, rest.join("-"))
}

fn find_compiler() -> Words {
    if let Some(given) = variable_of_target("CC") {
        return words(&given);
    }
    let clang = format!("clang --target={}", env::var("TARGET").unwrap());
    let tried = if is_cross() {
        vec![format!("{}gcc", prefix()), clang]
    } else if target_is("ENV", "musl") {
        vec!["musl-gcc".to_owned(), "cc".to_owned(), clang]
    } else {
        vec!["cc".to_owned(), "gcc".to_owned(), "clang".to_owned()]
    };
    match tried.iter().map(|each| words(each)).find(works) {
        Some(found) => found,
        None => fail(&format!(
            "there is no C compiler ({}): install gcc or clang, set CC, or install the library",
            tried.join(", ")
        )),
    }
}

fn find_archiver(compiler: &Words) -> Words {
    if let Some(given) = variable_of_target("AR") {
        return words(&given);
    }
    let mut tried = Vec::new();
    if is_cross() {
        tried.push(format!("{}ar", prefix()));
    }
    if compiler[0].contains("clang") {
        tried.push("llvm-ar".to_owned());
    }
    tried.push("ar".to_owned());
    tried.push("llvm-ar".to_owned());
    match tried.iter().map(|each| words(each)).find(works) {
        Some(found) => found,
        None if !is_cross() => words("ar"), // that of BSD has no --version
        None => fail(&format!("there is no archiver ({}): set AR", tried.join(", "))),
    }
}

/// Compiles as many files at a time as cargo allows. Gives the objects, in the order of the jobs.
fn compile_all(compiler: &Words, jobs: Vec<Job>, header: &Path, out: &Path) -> Vec<PathBuf> {
    let flags = flags();
    let at_once = env::var("NUM_JOBS").ok().and_then(|n| n.parse().ok()).unwrap_or(1);
    let mut objects = Vec::new();
    let mut running = VecDeque::new();
    for (i, (source, own)) in jobs.into_iter().enumerate() {
        if running.len() >= at_once {
            finish(running.pop_front());
        }
        let object = out.join(format!("{}-{}.o", i, source.file_stem().unwrap().to_str().unwrap()));
        let mut command = Command::new(&compiler[0]);
        command.args(&compiler[1..]).args(own).args(&flags).arg("-I").arg(header).arg("-c");
        command.arg(&source).arg("-o").arg(&object);
        objects.push(object);
        running.push_back(thread::spawn(move || run(&mut command)));
    }
    while !running.is_empty() {
        finish(running.pop_front());
    }
    objects
}

fn finish(running: Option<thread::JoinHandle<()>>) {
    if running.map_or(false, |thread| thread.join().is_err()) {
        exit(1);
    }
}

fn run(command: &mut Command) {
    match command.status() {
        Ok(status) if status.success() => (),
        Ok(status) => fail(&format!("{:?}: {}", command, status)),
        Err(error) => fail(&format!("{:?}: {}", command, error)),
    }
}

fn archive(compiler: &Words, objects: &[PathBuf], library: &Path) {
    let archiver = find_archiver(compiler);
    let _ = fs::remove_file(library); // it would keep old members
    run(Command::new(&archiver[0]).args(&archiver[1..]).arg("crs").arg(library).args(objects));
}
