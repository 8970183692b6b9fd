use std::fmt::Write;
fn main() {
    let mut seed: u64 = 7;
    let mut rnd = || { seed ^= seed << 13; seed ^= seed >> 7; seed ^= seed << 17; (seed >> 11) as f64 / (1u64<<53) as f64 };
    for (n, task) in [(3,"position"),(4,"position+"),(5,"position_axis"),(5,"pose"),(6,"position_axis+"),(6,"pose"),(7,"pose+")] {
        let mut bad: Vec<(String,String)> = Vec::new();
        for word in 0..1u32<<n {
            let mut text = format!("name: arm\nconvention: standard\nunits: {{length: m, angle: deg}}\n");
            let red = task.ends_with('+');
            let t = task.trim_end_matches('+');
            if red { let _ = write!(text, "inverse: {{task: {t}, redundant: q2}}\n"); } else { let _ = write!(text, "inverse: {{task: {t}}}\n"); }
            text += "joints:\n";
            let mut w = String::new();
            for j in 0..n {
                let p = word >> j & 1 == 1;
                w.push(if p {'P'} else {'R'});
                let (a, al, d, th) = (rnd()*0.6-0.3, rnd()*300.0-150.0, rnd()*0.6-0.3, rnd()*300.0-150.0);
                if p { let _ = write!(text, "  - {{type: prismatic, a: {a:.3}, alpha: {al:.1}, d: 0, theta: {th:.1}}}\n"); }
                else { let _ = write!(text, "  - {{a: {a:.3}, alpha: {al:.1}, d: {d:.3}, theta: 0}}\n"); }
            }
            match denhart_codegen::check(&text, "a.yaml") {
                Ok(r) => if let Some(u) = r.unsupported { bad.push((w, u)) },
                Err(e) => bad.push((w, format!("ERR {e:?}"))),
            }
        }
        println!("== {n} {task}: {} of {} refused", bad.len(), 1u32<<n);
        let mut reasons: std::collections::BTreeMap<String, Vec<String>> = Default::default();
        for (w,u) in bad { reasons.entry(u.chars().take(110).collect()).or_default().push(w); }
        for (r, w) in reasons { println!("  {} {r}: {}", w.len(), w.iter().take(8).cloned().collect::<Vec<_>>().join(" ")); }
    }
}
