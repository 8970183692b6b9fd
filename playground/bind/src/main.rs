//! Makes the JavaScript that calls the page's WebAssembly.
//!
//! `denhart-bind WASM FOLDER` writes `denhart_page.js`, its types, and `denhart_page.wasm.gz` to the folder.

mod order;
mod pack;

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1);
    let (Some(wasm), Some(folder), None) = (arguments.next(), arguments.next(), arguments.next()) else {
        eprintln!("usage: denhart-bind WASM FOLDER");
        return ExitCode::from(2);
    };
    match make(Path::new(&wasm), Path::new(&folder)) {
        Ok(said) => {
            println!("{said}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn make(wasm: &Path, folder: &Path) -> Result<String, String> {
    let mut bindgen = Bindgen::new();
    let bindgen = bindgen.input_path(wasm).web(true).map_err(|error| format!("{error:#}"))?;
    bindgen.typescript(true).omit_default_module_path(true).remove_name_section(true).remove_producers_section(true);
    bindgen.generate(folder).map_err(|error| format!("{error:#}"))?;
    let bound = folder.join("denhart_page_bg.wasm");
    let module = fs::read(&bound).map_err(|error| format!("{}: {error}", bound.display()))?;
    let packed = pack::pack(&module)?;
    let mut zipped = Vec::new();
    let options =
        zopfli::Options { iteration_count: 5.try_into().unwrap_or(std::num::NonZeroU64::MIN), ..Default::default() };
    zopfli::compress(options, zopfli::Format::Gzip, packed.as_slice(), &mut zipped)
        .map_err(|error| error.to_string())?;
    let out = folder.join("denhart_page.wasm.gz");
    fs::write(&out, &zipped).map_err(|error| format!("{}: {error}", out.display()))?;
    fs::remove_file(&bound).map_err(|error| format!("{}: {error}", bound.display()))?;
    let [before, after, small] = [module.len(), packed.len(), zipped.len()].map(|bytes| bytes / 1000);
    Ok(format!("module of {before} kB, {after} kB packed, {small} kB gzip"))
}
