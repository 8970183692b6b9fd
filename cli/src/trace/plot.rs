//! The curves of a motion as SVG: panels over the time, each with its unit, its legend and the limits of joints.

use plotters::prelude::*;
use plotters::series::DashedLineSeries;

/// A curve.
pub struct Curve {
    pub name: String,
    /// One for each time.
    pub values: Vec<f64>,
    /// Limits, marked where the panel has them; infinite ones are none.
    pub limits: [f64; 2],
}

/// Curves of one unit.
pub struct Panel {
    pub title: String,
    pub unit: String,
    pub curves: Vec<Curve>,
}

/// Colors that color-blind people tell apart: those of Okabe and Ito, with two more.
const COLORS: [RGBColor; 8] = [
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xcc, 0x79, 0xa7),
    RGBColor(0x3a, 0x3f, 0x45),
    RGBColor(0xe6, 0x9f, 0x00),
    RGBColor(0x56, 0xb4, 0xe9),
    RGBColor(0x8a, 0x5a, 0x2b),
];
const BEYOND: RGBColor = RGBColor(0xb3, 0x12, 0x3f);
const FONT: &str = "'Noto Sans','DejaVu Sans',Verdana,sans-serif";
/// Width of the picture, height of a row of panels, and of the title, px.
const WIDTH: u32 = 1000;
const ROW: u32 = 260;
const HEAD: u32 = 36;
/// Coordinates are whole numbers of this part of a pixel, so that curves have no steps.
const FINE: u32 = 4;
/// The part of the time axis beside the curves, where the legend stands.
const LEGEND: f64 = 0.17;
/// Values beyond this have no place on an axis.
const MOST: f64 = 1e100;
/// Of more samples than this the least and the greatest of each column are drawn.
const COLUMNS: usize = 800;
/// Names are cut to so many characters, so that the legend leaves room for the curves.
const NAME: usize = 16;
/// Limits within this part of a panel's range beyond its curves are shown.
const NEAR: f64 = 0.6;

/// The picture of panels, two in a row.
///
/// # Errors
/// The message.
pub fn svg(title: &str, times: &[f64], panels: &[Panel]) -> Result<String, String> {
    for panel in panels {
        let of = |curve: &Curve| {
            Some((curve.name.clone(), curve.values.iter().position(|x| !x.is_finite() || x.abs() > MOST)?))
        };
        if let Some((name, index)) = panel.curves.iter().find_map(of) {
            let t = times.get(index).copied().unwrap_or_default();
            return Err(format!(
                "--plot: `{name}` of the {} is beyond {MOST:e} {} at t = {t}",
                panel.title, panel.unit
            ));
        }
    }
    let title = &printable(title);
    let mut text = String::new();
    let rows = panels.len().div_ceil(2).max(1);
    let height = HEAD + ROW * u32::try_from(rows).map_err(|error| error.to_string())?;
    {
        let area = SVGBackend::with_string(&mut text, (FINE * WIDTH, FINE * height)).into_drawing_area();
        let other = |error: DrawingAreaErrorKind<_>| error.to_string();
        area.fill(&WHITE).map_err(other)?;
        let area = area.titled(title, (FONT, fine(21)).into_font().color(&COLORS[4])).map_err(other)?;
        for (part, panel) in area.split_evenly((rows, 2)).iter().zip(panels) {
            draw(part, times, panel).map_err(other)?;
        }
        area.present().map_err(other)?;
    }
    let size = |scale: u32| format!("width=\"{}\" height=\"{}\"", scale * WIDTH, scale * height);
    Ok(text.replacen(&size(FINE), &size(1), 1))
}

/// A length in px as the picture counts it.
fn fine(px: u32) -> u32 {
    FINE * px
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type Failed<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

/// The ends of the values, with the limits that are near, and some space.
fn range(panel: &Panel) -> [f64; 2] {
    let values = || panel.curves.iter().flat_map(|curve| curve.values.iter().copied());
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    // A curve that does not change is drawn in a range of its own size.
    let least = (0.05 * low.abs().max(high.abs())).max(1e-9);
    let size = (high - low).max(least);
    let near = |limit: &f64| *limit > low - NEAR * size && *limit < high + NEAR * size;
    let limits = || panel.curves.iter().flat_map(|curve| curve.limits).filter(near);
    let (low, high) = (limits().fold(low, f64::min), limits().fold(high, f64::max));
    let space = 0.06 * (high - low).max(least);
    [low - space, high + space]
}

fn draw<'a>(area: &Area<'a>, times: &[f64], panel: &Panel) -> Result<(), Failed<'a>> {
    let (first, last) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(1.0));
    let [low, high] = range(panel);
    let text = |size: u32| (FONT, fine(size)).into_font().color(&COLORS[4]);
    let line = |color: &RGBColor, px: u32| color.stroke_width(fine(px));
    let end = if last > first { last } else { first + 1.0 };
    let beside = LEGEND / (1.0 - LEGEND) * (end - first);
    let mut chart = ChartBuilder::on(area)
        .margin(fine(8))
        .margin_right(fine(14))
        .caption(format!("{}, {}", panel.title, panel.unit), text(17))
        .x_label_area_size(fine(36))
        .y_label_area_size(fine(62))
        .build_cartesian_2d(first..end + beside, low..high)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(line(&RGBColor(0xe3, 0xe7, 0xeb), 1))
        .axis_style(line(&RGBColor(0x62, 0x6c, 0x76), 1))
        .set_all_tick_mark_size(fine(5))
        .x_desc("t, s")
        .x_labels(6)
        .y_labels(6)
        .x_label_formatter(&|value| label(*value))
        .y_label_formatter(&|value| label(*value))
        .label_style(text(15))
        .axis_desc_style(text(15))
        .draw()?;
    for (curve, color) in panel.curves.iter().zip(COLORS.iter().cycle()) {
        for limit in curve.limits.into_iter().filter(|limit| *limit > low && *limit < high) {
            let ends = [(first, limit), (end, limit)];
            chart.draw_series(DashedLineSeries::new(ends, fine(6), fine(4), line(color, 1)))?;
        }
        let points = || times.iter().copied().zip(curve.values.iter().copied());
        chart
            .draw_series(LineSeries::new(thinned(points()), line(color, 2)))?
            .label(short_name(&curve.name))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 72, y)], color.stroke_width(fine(2))));
        let [lower, upper] = curve.limits;
        for stretch in stretches(points(), |value| value < lower || value > upper) {
            chart.draw_series(LineSeries::new(thinned(stretch.into_iter()), line(&BEYOND, 4)))?;
        }
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .legend_area_size(fine(24))
        .margin(fine(6))
        .label_font(text(15))
        .draw()
}

/// A curve of few points as it is. Of many points the least and the greatest of each column, in their order: nothing that
/// a picture can show is lost.
fn thinned(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let all: Vec<(f64, f64)> = points.collect();
    let column = all.len().div_ceil(COLUMNS).max(1);
    if column < 3 {
        return all;
    }
    let ends = |part: &[(f64, f64)]| {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let mut ends: Vec<(f64, f64)> =
            part.iter().min_by(by_value).into_iter().chain(part.iter().max_by(by_value)).copied().collect();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        ends
    };
    let first = all.first().copied();
    let last = all.last().copied();
    first.into_iter().chain(all.chunks(column).flat_map(ends)).chain(last).collect()
}

/// Without characters that XML does not have.
fn printable(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

fn short_name(name: &str) -> String {
    let name = printable(name);
    match name.chars().count() > NAME {
        true => name.chars().take(NAME - 1).chain(['\u{2026}']).collect(),
        false => name,
    }
}

/// The parts of a curve whose values are meant.
fn stretches(points: impl Iterator<Item = (f64, f64)>, meant: impl Fn(f64) -> bool) -> Vec<Vec<(f64, f64)>> {
    let mut found: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut inside = false;
    for (t, value) in points {
        let now = meant(value);
        match found.last_mut() {
            Some(last) if now && inside => last.push((t, value)),
            _ if now => found.push(vec![(t, value)]),
            _ => {}
        }
        inside = now;
    }
    found
}

/// A number at an axis.
fn label(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude != 0.0 && !(1e-3..1e5).contains(&magnitude) {
        return format!("{value:.1e}");
    }
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn panel(values: &[f64], limits: [f64; 2]) -> Panel {
        let curve = Curve { name: "q1".to_owned(), values: values.to_vec(), limits };
        Panel { title: "joints".to_owned(), unit: "deg".to_owned(), curves: vec![curve] }
    }

    #[test]
    fn the_same_curves_give_the_same_bytes() {
        let panels = [panel(&[0.0, 1.0, 4.0], [-1.0, 3.0])];
        let text = svg("a", &[0.0, 1.0, 2.0], &panels).unwrap();
        assert_eq!(svg("a", &[0.0, 1.0, 2.0], &panels).unwrap(), text);
        assert!(text.contains("joints, deg") && text.contains("t, s") && text.contains("q1"));
    }

    #[test]
    fn values_that_no_axis_has_are_told_and_names_are_printable() {
        for value in [f64::INFINITY, f64::NAN, 1e200] {
            let error = svg("a", &[0.0, 1.0], &[panel(&[0.0, value], [-1.0, 3.0])]).unwrap_err();
            assert!(error.contains("`q1` of the joints is beyond 1e100 deg at t = 1"), "{error}");
        }
        let mut named = panel(&[0.0, 1.0], [-1.0, 3.0]);
        named.curves[0].name = "a\u{2}b is a long name of a joint".to_owned();
        let text = svg("b\u{1}", &[0.0, 1.0], &[named]).unwrap();
        assert!(!text.contains(['\u{1}', '\u{2}']) && text.contains("a b is a long n\u{2026}"), "{text}");
    }

    #[test]
    fn a_peak_among_many_samples_is_drawn() {
        let peak = |t: usize| if t == 5000 { 7.0 } else { (t % 2) as f64 };
        let drawn = thinned((0..10_000).map(|t| (t as f64, peak(t))));
        assert!(drawn.len() <= 2 * COLUMNS + 2 && drawn.contains(&(5000.0, 7.0)), "{}", drawn.len());
        assert!(drawn.is_sorted_by(|a, b| a.0 <= b.0));
    }

    #[test]
    fn limits_far_away_do_not_flatten_a_curve() {
        let [low, high] = range(&panel(&[0.0, 10.0], [-360.0, 12.0]));
        assert!(low > -2.0 && high > 12.0 && high < 14.0, "{low} {high}");
        let [low, high] = range(&panel(&[5.0, 5.0], [f64::NEG_INFINITY, f64::INFINITY]));
        assert!(low < 5.0 && high > 5.0);
    }

    #[test]
    fn stretches_beyond_a_limit_are_found() {
        let points = [0.0, 2.0, 3.0, 0.0, 2.0].into_iter().enumerate().map(|(t, value)| (t as f64, value));
        assert_eq!(stretches(points, |value| value > 1.0), [vec![(1.0, 2.0), (2.0, 3.0)], vec![(4.0, 2.0)]]);
    }
}
