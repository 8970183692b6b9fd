//! Bytes and symbols of a linked program.

use std::fs;
use std::path::Path;

use object::elf::SHF_ALLOC;
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, SectionKind, SymbolKind};

use crate::Error;

/// Routines of the compiler for double precision: of the ARM run-time ABI, and by their older names.
const DOUBLE: [&str; 9] = [
    "__aeabi_d",
    "__aeabi_f2d",
    "__aeabi_i2d",
    "__aeabi_ui2d",
    "__aeabi_l2d",
    "__aeabi_ul2d",
    "__extendsfdf2",
    "__truncdfsf2",
    "__muldf3",
];

/// A function or a constant.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Symbol {
    size: u64,
    address: u64,
    name: String,
}

/// A program as its ELF file describes it: size, and symbols by address.
#[derive(Debug)]
pub struct Program {
    /// Bytes of flash: sections that are loaded and have contents.
    pub flash: u64,
    /// Functions and constants, largest first.
    symbols: Vec<Symbol>,
    /// Places of functions in `symbols`, by address.
    by_address: Vec<usize>,
}

impl Program {
    /// Of the ELF file at `path`.
    ///
    /// # Errors
    /// The file cannot be read, or is no ELF file.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let data = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let file = object::File::parse(data.as_slice())?;
        let loaded = |section: &object::Section<'_, '_>| {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { return false };
            sh_flags.0 & SHF_ALLOC.0 != 0 && section.kind() != SectionKind::UninitializedData
        };
        let flash = file.sections().filter(loaded).map(|section| section.size()).sum();
        let mut symbols: Vec<Symbol> = file
            .symbols()
            .filter(|symbol| matches!(symbol.kind(), SymbolKind::Text | SymbolKind::Data))
            .filter_map(|symbol| {
                let name = format!("{:#}", rustc_demangle::demangle(symbol.name().ok()?));
                // The lowest bit of a function's address says that it is Thumb code.
                Some(Symbol { size: symbol.size(), address: symbol.address() & !1, name })
            })
            .collect();
        symbols.sort_by(|a, b| b.size.cmp(&a.size).then_with(|| a.name.cmp(&b.name)));
        symbols.dedup();
        let mut by_address: Vec<usize> = (0..symbols.len()).collect();
        by_address.sort_by_key(|&index| symbols.get(index).map(|symbol| symbol.address));
        Ok(Self { flash, symbols, by_address })
    }

    /// The name of the function that the instruction at `address` belongs to.
    pub fn symbol_at(&self, address: u64) -> Option<&str> {
        let of = |&index: &usize| self.symbols.get(index);
        let after = self.by_address.partition_point(|index| of(index).is_some_and(|symbol| symbol.address <= address));
        let before = self.by_address.get(..after)?;
        let covers = |symbol: &&Symbol| address < symbol.address + symbol.size;
        before.iter().rev().take(4).filter_map(of).find(covers).map(|symbol| symbol.name.as_str())
    }

    /// Prints the `count` largest.
    pub fn print_symbols(&self, count: usize) {
        for Symbol { size, name, .. } in self.symbols.iter().take(count) {
            println!("{size:7}  {name}");
        }
    }

    /// # Errors
    /// Names the routines of double precision that the program has.
    pub fn has_no_doubles(&self) -> Result<(), Error> {
        let found: Vec<&str> = self
            .symbols
            .iter()
            .map(|symbol| symbol.name.as_str())
            .filter(|name| DOUBLE.iter().any(|routine| name.starts_with(routine)))
            .collect();
        if found.is_empty() { Ok(()) } else { Err(format!("double precision: {}", found.join(", ")).into()) }
    }

    /// # Errors
    /// Names what the program has of panics: the handler is in it only if something calls it.
    pub fn has_no_panics(&self) -> Result<(), Error> {
        let names = self.symbols.iter().map(|symbol| symbol.name.as_str());
        let found: Vec<&str> = names.filter(|name| name.contains("panic") || name.contains("begin_unwind")).collect();
        if found.is_empty() { Ok(()) } else { Err(format!("a path to a panic: {}", found.join(", ")).into()) }
    }
}
