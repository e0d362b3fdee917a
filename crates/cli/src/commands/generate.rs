mod python;
mod ray;

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

use oaktwin::diagnostic::Finding;
use oaktwin::files;
use oaktwin::generate::recipe::{self, RecipeFile, Texts};
use oaktwin::generate::{GenerateOptions, Generated, Generator};
use oaktwin::image::png;
use oaktwin::memory;
use serde::Serialize;

use crate::args::GenerateArgs;
use crate::context::{Context, Exit, Result};
use crate::{output, progress};

/// The JSON output of `generate`.
#[derive(Serialize)]
struct GenerateReport<'a> {
    output: &'a Path,
    frames: u64,
    frames_skipped: u64,
    frames_missing: u64,
    files: u64,
    bytes: u64,
    seconds: f64,
    interrupted: bool,
    findings: &'a [Finding],
}

pub(crate) fn run(context: &Context, args: &GenerateArgs) -> Result<Exit> {
    if args.schema {
        output::print_json(&recipe::schema())?;
        return Ok(Exit::Success);
    }
    let Some(path) = &args.recipe else {
        return Err("name a recipe".into());
    };
    args.threads.apply();
    let mut file = RecipeFile::read(path)?;
    if !args.formats.is_empty() {
        file.recipe.output.formats = Texts(args.formats.clone());
    }
    file.recipe.output.scenes |= args.save_scenes;
    file.recipe.seed = args.seed.unwrap_or(file.recipe.seed);
    let generator = Generator::open(file, &context.catalog)?;
    if let Some(frame) = args.explain {
        output::print_json(&generator.explain(frame)?)?;
        return Ok(Exit::Success);
    }
    let Some(folder) = &args.output else {
        return Err("name the folder of the data set with --output".into());
    };
    if let Some(frames) = args.preview {
        let sheet = generator.preview(frames, &|_| ControlFlow::Continue(()))?;
        files::write(folder, &png::encode(&sheet)?)?;
        output::print(&format!("{}\n", folder.display()))?;
        return Ok(Exit::Success);
    }
    let options = GenerateOptions {
        frames: args.frames.clone(),
        resume: args.resume,
        verify: args.verify,
        workers: args.workers.map(usize::from),
        only_frames: args.only_frames,
    };
    let start = Instant::now();
    let generated = progress::watched(|watch| {
        let mut generation = generator.start(folder, &options)?;
        match &args.ray {
            Some(address) => ray::make(context, args, address, &mut generation, watch)?,
            None => generation.make(options.workers, watch)?,
        }
        Result::Ok(generation.finish()?)
    })?;
    report(args, folder, &generated, start.elapsed().as_secs_f64())
}

fn report(args: &GenerateArgs, folder: &Path, generated: &Generated, seconds: f64) -> Result<Exit> {
    if args.json {
        output::print_json(&GenerateReport {
            output: folder,
            frames: generated.made,
            frames_skipped: generated.skipped,
            frames_missing: generated.missing,
            files: generated.files,
            bytes: generated.bytes,
            seconds,
            interrupted: generated.is_interrupted,
            findings: &generated.findings,
        })?;
    } else {
        output::say_findings(folder, &generated.findings);
        output::print(&text(folder, generated, seconds))?;
    }
    Ok(if generated.is_interrupted {
        Exit::Interrupted
    } else {
        Exit::Success
    })
}

fn text(folder: &Path, generated: &Generated, seconds: f64) -> String {
    let frames = |count: u64| format!("{count} frame{}", if count == 1 { "" } else { "s" });
    let mut text = format!("{}: {}", folder.display(), frames(generated.made));
    if generated.made > 0 {
        #[expect(clippy::cast_precision_loss, reason = "a rate for people")]
        let rate = generated.made as f64 / seconds.max(1e-9);
        text += &format!(", {rate:.1} per second");
    }
    if generated.skipped > 0 {
        let verb = if generated.skipped == 1 { "was" } else { "were" };
        text += &format!("; {} {verb} complete already", generated.skipped);
    }
    if generated.is_interrupted {
        return text + "; interrupted: continue with --resume\n";
    }
    if generated.files == 0 {
        return text + "; the data set is completed by --resume\n";
    }
    text += &format!("; {} files, {}", generated.files, memory::size(generated.bytes));
    if generated.missing > 0 {
        let verb = if generated.missing == 1 { "is" } else { "are" };
        text += &format!(
            "; {} of the recipe {verb} missing: add with --resume",
            frames(generated.missing)
        );
    }
    text + "\n"
}
