//! The form of an arm file as a JSON schema, for editors.
//!
//! An editor completes keys by it and marks unknown ones while they are typed. What values mean together is
//! `denhart check`'s.

use serde_json::{Value, json};

/// The schema as text, indented.
#[must_use]
pub fn text() -> String {
    format!("{:#}", schema())
}

/// The schema (draft 7, which editors for YAML read).
#[must_use]
pub fn schema() -> Value {
    json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "Arm file of denhart",
        "description": "The Denavit-Hartenberg table of a serial robot arm.",
        "type": "object",
        "required": ["convention", "joints"],
        "additionalProperties": false,
        "properties": {
            "name": {"type": "string", "description": "Name of the arm."},
            "convention": {
                "enum": ["standard", "modified"],
                "description": "standard: row i is Rz(theta) Tz(d) Tx(a) Rx(alpha). modified (Craig): row i is Rx(alpha) Tx(a) Rz(theta) Tz(d), with a and alpha of the link before."
            },
            "units": object(
                "Units of all lengths and angles; without it m and degrees.",
                json!({"length": {"enum": ["m", "cm", "mm", "in"]}, "angle": {"enum": ["deg", "rad"]}}),
                json!([])
            ),
            "joints": {
                "type": "array",
                "minItems": 1,
                "items": {"$ref": "#/definitions/row"},
                "description": "One row a joint, from base to tool; at most ten rows move."
            },
            "base": {"$ref": "#/definitions/frame", "description": "Constant frame before the first row."},
            "tool": {"$ref": "#/definitions/frame", "description": "Constant frame after the last row."},
            "parameters": {
                "type": "object",
                "additionalProperties": {"$ref": "#/definitions/number"},
                "description": "Names for lengths with their values; a field of the struct of that name binds one at run time."
            },
            "calibration": {
                "type": "object",
                "description": "What is added to the rows of the table, by joint, where the arm was measured.",
                "additionalProperties": object(
                    "Added to the row of a joint.",
                    json!({
                        "a": {"$ref": "#/definitions/number"},
                        "alpha": {"$ref": "#/definitions/angle"},
                        "d": {"$ref": "#/definitions/number"},
                        "theta": {"$ref": "#/definitions/angle"}
                    }),
                    json!([])
                )
            },
            "inverse": inverse(),
            "coupling": coupling(),
            "combined_limits": {
                "type": "array",
                "description": "Ranges of sums of joint values.",
                "items": object(
                    "A sum and its range.",
                    json!({
                        "sum": {
                            "anyOf": [
                                {"type": "object", "additionalProperties": {"$ref": "#/definitions/number"}},
                                {"type": "array", "items": {"type": "string"}}
                            ],
                            "description": "Factors of the joints, by name; a list of names for factors of 1."
                        },
                        "limits": {"$ref": "#/definitions/limits"}
                    }),
                    json!(["sum", "limits"])
                )
            }
        },
        "definitions": {
            "number": {"type": ["number", "string"], "description": "A number, which may stand in quotes."},
            "angle": {
                "type": ["number", "string"],
                "description": "A number in the file's unit, or text with its own: 90 deg, 1.5 rad, pi/2, -2*pi/3."
            },
            "length": {
                "type": ["number", "string"],
                "description": "A number in the file's unit, or a parameter with a sign or a factor: -l2, 2*l2, l2/2."
            },
            "limits": {
                "anyOf": [
                    {"type": "null"},
                    {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": ["number", "string", "null"]}}
                ],
                "description": "[lowest, highest]; null for no limit."
            },
            "frame": object(
                "A constant frame.",
                json!({
                    "xyz": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"$ref": "#/definitions/length"}},
                    "rpy": {
                        "type": "array",
                        "minItems": 3,
                        "maxItems": 3,
                        "items": {"$ref": "#/definitions/angle"},
                        "description": "Roll, pitch, yaw: Rz(yaw) Ry(pitch) Rx(roll)."
                    }
                }),
                json!([])
            ),
            "row": row()
        }
    })
}

/// A mapping with known keys.
fn object(description: &str, properties: Value, required: Value) -> Value {
    json!({
        "type": "object",
        "description": description,
        "properties": properties,
        "required": required,
        "additionalProperties": false
    })
}

fn row() -> Value {
    let actuator = object(
        "A motor that counts pulses.",
        json!({
            "pulses_per_rev": {"type": ["number", "string"], "description": "Of a turning joint."},
            "pulses_per_unit": {"type": ["number", "string"], "description": "Of a sliding joint."},
            "gear_ratio": {"type": ["number", "string"], "description": "Multiplies pulses_per_rev."},
            "home": {"type": ["number", "string"], "description": "The motor's value at a count of 0."},
            "direction": {"enum": [1, -1, "1", "-1"]}
        }),
        json!([]),
    );
    object(
        "A joint, or a constant row.",
        json!({
            "type": {
                "enum": ["revolute", "prismatic", "fixed"],
                "description": "revolute (the default) adds the joint's value to theta, prismatic to d; a fixed row does not move."
            },
            "name": {"type": "string", "description": "Without it q1, q2, ..."},
            "a": {"$ref": "#/definitions/length", "description": "Length along x."},
            "alpha": {"$ref": "#/definitions/angle", "description": "Angle about x."},
            "d": {"$ref": "#/definitions/length", "description": "Length along z."},
            "theta": {"$ref": "#/definitions/angle", "description": "Angle about z, to which a turning joint adds."},
            "limits": {"$ref": "#/definitions/limits"},
            "actuator": actuator
        }),
        json!(["a", "alpha", "d", "theta"]),
    )
}

fn inverse() -> Value {
    let tolerance = object(
        "What is still listed as approximate.",
        json!({"length": {"$ref": "#/definitions/number"}, "angle": {"$ref": "#/definitions/angle"}}),
        json!([]),
    );
    object(
        "What the inverse is asked for.",
        json!({
            "task": {"enum": ["pose", "position_angle", "position_axis", "position", "planar_pose", "planar_position"]},
            "require": {"type": "boolean", "description": "An arm without inverse fails to compile."},
            "redundant": {
                "anyOf": [
                    {"type": ["string", "null"]},
                    {"type": "array", "minItems": 1, "items": {"type": "string"}}
                ],
                "description": "The joint whose value is given, or arm_angle; a list of them where the arm has several joints more than its task needs."
            },
            "axis": {"enum": ["x", "y", "z"], "description": "The tool's axis that position_axis points."},
            "tolerance": tolerance,
            "weights": {
                "anyOf": [
                    {"type": "object", "additionalProperties": {"$ref": "#/definitions/number"}},
                    {"type": "array", "items": {"$ref": "#/definitions/number"}}
                ],
                "description": "How much each joint counts in the distance that inverse_near sorts by."
            }
        }),
        json!([]),
    )
}

fn coupling() -> Value {
    let factor = json!({"type": ["number", "string"], "description": "A number, or a length for a turn: 20 per rev."});
    let matrix = json!({"type": "array", "items": {"type": "array", "items": factor}});
    json!({
        "description": "Linked motors: motor = A q + b. A joint that is not listed is driven one to one by its own motor.",
        "anyOf": [
            matrix,
            {
                "type": "object",
                "properties": {
                    "matrix": matrix,
                    "offset": {"type": "array", "items": {"type": ["number", "string"]}}
                },
                "required": ["matrix"],
                "additionalProperties": false
            },
            {"type": "object", "additionalProperties": {"type": "object", "additionalProperties": factor}}
        ]
    })
}
