//! Where libtalus is: in TALUS_LIB_DIR, otherwise by pkg-config, which PKG_CONFIG_PATH tells of other folders than the system's.
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=TALUS_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    if let Ok(folder) = std::env::var("TALUS_LIB_DIR") {
        println!("cargo:rustc-link-search=native={folder}");
        return;
    }
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
