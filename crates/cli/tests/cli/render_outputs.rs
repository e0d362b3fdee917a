//! `render`: sensor outputs that an engine does not support.

use crate::program::Program;

#[test]
fn unsupported_sensor_outputs_are_a_warning() {
    let program = Program::new();
    program.put("wall.obj", "v 1 -2 -2\nv 1 2 -2\nv 1 2 2\nv 1 -2 2\nf 1 2 3 4\n");
    let arguments = |annotators: &str, more: &str| {
        let arguments = format!(
            "render wall.obj --up z --model oak4-d --pose 0 0 0 0 0 0 1 --resolution 64x40 --engine stereo-noise \
             --annotators depth_sensor_distance,{annotators} {more}"
        );
        arguments
            .split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    for (annotators, more) in [
        ("depth_sensor_imager", "-o engine"),
        (
            "depth_sensor_output_visualization",
            "-o filters --filter decimation:decimationFactor=2",
        ),
    ] {
        let arguments = arguments(annotators, more);
        let mut arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        arguments.push("--strict");
        let error = program.refused(&arguments);
        assert!(error.contains("warning[sensor-output-missing]"), "{error}");
        arguments.pop();
        let ended = program.run(&arguments);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        assert!(ended.stderr.contains(annotators), "{}", ended.stderr);
        let folder = more.split(' ').nth(1).unwrap();
        let names = program.names();
        assert!(names.contains(&format!("{folder}/depth_sensor_distance_0000.npy")));
        assert!(!names.iter().any(|name| name.contains(annotators)), "{names:?}");
    }
}
