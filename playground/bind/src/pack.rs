//! A module in fewer bytes: functions with equal code become one, similar ones stand next to each other, where gzip finds them.

use std::collections::HashMap;
use std::convert::Infallible;

use wasm_encoder::reencode::{Error, Reencode, utils};
use wasm_encoder::{CodeSection, Encode, FunctionSection, Module};
use wasmparser::{CodeSectionReader, FunctionBody, FunctionSectionReader, Parser, Payload, TypeRef};

use crate::order::side_by_side;

/// Rounds in which functions that call equal ones are found equal.
const ROUNDS: usize = 12;

type Failed = Error<Infallible>;

/// The new places of functions.
struct Packer {
    imported: usize,
    types: Vec<u32>,
    /// The new index of each function, imported ones first.
    map: Vec<u32>,
    /// The functions that stay, in their new order, without the imported ones.
    order: Vec<usize>,
}

impl Reencode for Packer {
    type Error = Infallible;

    fn function_index(&mut self, function: u32) -> Result<u32, Failed> {
        Ok(self.map.get(function as usize).copied().unwrap_or(function))
    }

    fn parse_function_section(
        &mut self,
        functions: &mut FunctionSection,
        _section: FunctionSectionReader<'_>,
    ) -> Result<(), Failed> {
        for index in &self.order {
            functions.function(self.types.get(*index).copied().unwrap_or_default());
        }
        Ok(())
    }

    fn parse_code_section(&mut self, code: &mut CodeSection, section: CodeSectionReader<'_>) -> Result<(), Failed> {
        let bodies = section.into_iter().collect::<Result<Vec<FunctionBody<'_>>, _>>()?;
        for index in self.order.clone() {
            if let Some(body) = bodies.get(index) {
                self.parse_function_body(code, body.clone())?;
            }
        }
        Ok(())
    }
}

impl Packer {
    /// The bytes of a function with the indices of the map.
    fn bytes(&mut self, body: &FunctionBody<'_>) -> Result<Vec<u8>, Failed> {
        let mut code = CodeSection::new();
        utils::parse_function_body(self, &mut code, body.clone())?;
        let mut bytes = Vec::new();
        code.encode(&mut bytes);
        Ok(bytes)
    }
}

/// Packs a module.
///
/// # Errors
/// The message: bytes that are no module.
pub fn pack(wasm: &[u8]) -> Result<Vec<u8>, String> {
    packed(wasm).map_err(|error| error.to_string())
}

fn packed(wasm: &[u8]) -> Result<Vec<u8>, Failed> {
    let (mut imported, mut types, mut bodies) = (0, Vec::new(), Vec::new());
    for payload in Parser::new(0).parse_all(wasm) {
        match payload? {
            Payload::ImportSection(section) => {
                for import in section.into_imports() {
                    imported += usize::from(matches!(import?.ty, TypeRef::Func(_)));
                }
            }
            Payload::FunctionSection(section) => types = section.into_iter().collect::<Result<_, _>>()?,
            Payload::CodeSectionEntry(body) => bodies.push(body),
            _ => {}
        }
    }
    let all = u32::try_from(imported + bodies.len()).unwrap_or(u32::MAX);
    let mut packer = Packer { imported, types, map: (0..all).collect(), order: Vec::new() };
    let mut codes = Vec::new();
    for _ in 0..ROUNDS {
        codes = bodies.iter().map(|body| packer.bytes(body)).collect::<Result<Vec<_>, _>>()?;
        let mut first: HashMap<(Option<&u32>, &[u8]), usize> = HashMap::new();
        let mut kept = Vec::new();
        let mut map: Vec<u32> = (0..all).collect();
        for (index, code) in codes.iter().enumerate() {
            let same = *first.entry((packer.types.get(index), code)).or_insert(index);
            if same == index {
                kept.push(index);
            }
            if let Some(place) = map.get_mut(packer.imported + index) {
                *place = u32::try_from(packer.imported + same).unwrap_or(u32::MAX);
            }
        }
        let settled = map == packer.map;
        (packer.map, packer.order) = (map, kept);
        if settled {
            break;
        }
    }
    let kept: Vec<&[u8]> = packer.order.iter().filter_map(|index| codes.get(*index)).map(Vec::as_slice).collect();
    packer.order = side_by_side(&kept).into_iter().filter_map(|place| packer.order.get(place).copied()).collect();
    let mut place = vec![0; bodies.len()];
    for (new, old) in packer.order.iter().enumerate() {
        if let Some(place) = place.get_mut(*old) {
            *place = u32::try_from(imported + new).unwrap_or(u32::MAX);
        }
    }
    for target in packer.map.iter_mut().skip(imported) {
        let old = (*target as usize).saturating_sub(imported);
        *target = place.get(old).copied().unwrap_or(*target);
    }
    let mut module = Module::new();
    packer.parse_core_module(&mut module, Parser::new(0), wasm)?;
    Ok(module.finish())
}
