//! Where libtalus is, by pkg-config: PKG_CONFIG_PATH names other folders than the system's.
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    let output = match Command::new("pkg-config").args(["--libs-only-L", "--print-errors", "talus >= 1.0"]).output() {
        Ok(output) if output.status.success() => output,
        Ok(output) => fail(&String::from_utf8_lossy(&output.stderr)),
        Err(error) => fail(&format!("pkg-config: {error}")),
    };
    for flag in String::from_utf8_lossy(&output.stdout).split_whitespace() {
        println!("cargo:rustc-link-search=native={}", flag.trim_start_matches("-L"));
    }
}

fn fail(why: &str) -> ! {
    eprintln!("libtalus was not found by pkg-config; set PKG_CONFIG_PATH to the folder of talus.pc: {}", why.trim());
    std::process::exit(1)
}
