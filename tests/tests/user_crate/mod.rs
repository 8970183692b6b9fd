//! A crate as a user has it: a folder with a manifest, built by cargo. For what only rustc and cargo can show.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A crate in the folder cargo keeps for tests.
pub struct UserCrate {
    folder: PathBuf,
}

impl UserCrate {
    /// A new crate. `dependencies`: the lines of its manifest after the package, `$ROOT` standing for this repository.
    pub fn new(name: &str, dependencies: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        if folder.exists() {
            fs::remove_dir_all(&folder).unwrap();
        }
        let user = Self { folder };
        let manifest = format!("[package]\nname = \"{name}\"\nedition = \"2024\"\n\n{dependencies}\n[workspace]\n");
        user.write("Cargo.toml", &manifest.replace("$ROOT", &root().display().to_string()));
        // The versions of this repository: no newer ones are looked for.
        user.write("Cargo.lock", &fs::read_to_string(root().join("Cargo.lock")).unwrap());
        user
    }

    /// Writes a file of the crate.
    pub fn write(&self, file: &str, content: &str) {
        let path = self.folder.join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }

    /// Runs cargo in the crate. What no build of this repository needed before, such as `libm`, cargo fetches.
    pub fn cargo(&self, arguments: &[&str]) -> Output {
        // One folder for what all these crates depend on, and not the one the running test holds.
        let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("user_crates");
        Command::new(env!("CARGO"))
            .args(arguments)
            .arg("--quiet")
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", target)
            .env("CARGO_TERM_COLOR", "never")
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .output()
            .unwrap()
    }

    /// Runs cargo, which must succeed; returns what it prints.
    pub fn succeeds(&self, arguments: &[&str]) -> String {
        let output = self.cargo(arguments);
        assert!(output.status.success(), "cargo {arguments:?}:\n{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    }

    /// Runs cargo, which must fail; returns the errors, `$CRATE` standing for the folder.
    pub fn fails(&self, arguments: &[&str]) -> String {
        let output = self.cargo(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success(), "cargo {arguments:?} succeeds:\n{errors}");
        errors.replace(&self.folder.display().to_string(), "$CRATE")
    }
}

/// The folder of this repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}
