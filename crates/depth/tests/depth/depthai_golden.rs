//! What `DepthAI`'s own host filters made of some images, recorded.

use std::error::Error;
use std::path::PathBuf;

use oaktwin_depth::filter::{Chain, Filter, Pixel, parse};
use oaktwin_image::Image;
use serde_json::Value;

/// Returns the recorded cases.
fn cases() -> Result<Vec<Value>, Box<dyn Error>> {
    let folder = std::env::var_os("OAKTWIN_TEST_DATA").ok_or("OAKTWIN_TEST_DATA is not set")?;
    let path = PathBuf::from(folder).join("data/depthai-golden/image_filters.json");
    let text = std::fs::read_to_string(&path)?;
    let file: Value = serde_json::from_str(&text)?;
    Ok(file["cases"].as_array().cloned().ok_or("no cases")?)
}

/// A case's filter as text, under the settings' own names.
fn filter(case: &Value) -> Result<Filter, Box<dyn Error>> {
    let settings = case["params"].as_object().ok_or("no settings")?;
    let settings = settings.iter().map(|(name, value)| match value {
        Value::String(text) => format!("{name}={text}"),
        number => format!("{name}={number}"),
    });
    let name = case["name"].as_str().ok_or("no name")?;
    Ok(parse(&format!(
        "{name}:{}",
        settings.collect::<Vec<_>>().join(",")
    ))?)
}

fn frames<P: Pixel + serde::de::DeserializeOwned>(frames: &Value) -> Result<Vec<Image<P>>, Box<dyn Error>> {
    let frames: Vec<Vec<Vec<P>>> = serde_json::from_value(frames.clone())?;
    let images = frames.into_iter().map(|rows| {
        let width = u32::try_from(rows.first().map_or(0, Vec::len))?;
        let height = u32::try_from(rows.len())?;
        Ok(Image::new(width, height, rows.concat()).ok_or("rows of unequal length")?)
    });
    images.collect()
}

fn check<P: Pixel + serde::de::DeserializeOwned>(case: &Value) -> Result<(), Box<dyn Error>> {
    let mut chain = Chain::new(vec![filter(case)?]);
    let (before, after) = (frames::<P>(&case["in"])?, frames::<P>(&case["out"])?);
    assert_eq!(before.len(), after.len());
    assert!(!before.is_empty());
    for (number, (before, after)) in before.into_iter().zip(after).enumerate() {
        let filtered = chain.run(before);
        assert_eq!(
            filtered, after,
            "frame {number} of {} {}",
            case["name"], case["params"]
        );
    }
    Ok(())
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn filters_are_depthais_bit_for_bit() -> Result<(), Box<dyn Error>> {
    let cases = cases()?;
    for case in &cases {
        match case["dtype"].as_str() {
            Some("uint8") => check::<u8>(case)?,
            Some("uint16") => check::<u16>(case)?,
            other => return Err(format!("{other:?} is not a pixel type").into()),
        }
    }
    Ok(())
}
