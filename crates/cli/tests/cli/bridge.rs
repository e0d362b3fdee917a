//! `bridge`: what it rejects before it takes part in a network. `tests/oracles/test_bridge.py` runs it.

use crate::program::Program;

#[test]
fn invalid_requests_are_rejected() {
    let program = Program::new();
    let mut all = String::new();
    for options in [
        &["--model", "OAK5"][..],
        &["--model", "OAK-D-Pro-PoE", "--engine", "stereo-matching"],
        &["--model", "OAK-D-Pro-PoE", "--preset", "robotcs"],
        &["--model", "OAK-D-Pro-PoE", "--param", "jiter=1"],
        &["--model", "OAK-D-Pro-PoE", "--sensor", "tof"],
        &["--model", "OAK-D-Pro-PoE", "--fx", "-1"],
        &["--model", "OAK-D-Pro-PoE", "--out", "/my oak"],
        &["--model", "OAK-D-Pro-PoE", "--rgb", "/oak/stereo/image_raw"],
        &["--model", "OAK-D-Pro-PoE", "--encoding", "mono16"],
        &["--model", "OAK-D-Pro-PoE", "--info", "/info", "--hfov", "70"],
        &["--model", "OAK-D-Pro-PoE", "--points-step", "4"],
        &["--model", "OAK-D-Pro-PoE", "--points", "--points-step", "0"],
        &["--model", "OAK-D-Pro-PoE", "--tf", "my oak"],
        &["--model", "OAK-D-Pro-PoE", "--latency", "soon"],
        &["--model", "OAK-D-Pro-PoE", "--latency", "0.2,0.1"],
        &["--model", "OAK-D-Pro-PoE", "--jitter", "-1"],
        &["--model", "OAK-D-Pro-PoE", "--drop", "1"],
        &["--model", "RealSense-D435i", "--latency", "catalog"],
        // An address for documentation (RFC 5737).
        &["--model", "OAK-D-Pro-PoE", "--interface", "198.51.100.7"],
    ] {
        let ended = program.run(&[&["bridge", "--depth", "/camera/depth"][..], options].concat());
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{options:?}");
        all += &format!("$ oaktwin bridge {}\n{}\n", options.join(" "), ended.stderr);
    }
    insta::assert_snapshot!(all);
}

#[test]
fn wrong_environments_are_rejected() {
    for (name, value, expected) in [
        (
            "ROS_DOMAIN_ID",
            "300",
            "error: ROS_DOMAIN_ID: unsupported value '300'; set a number from 0 to 232\n",
        ),
        (
            "ROS_LOCALHOST_ONLY",
            "yes",
            "error: ROS_LOCALHOST_ONLY: unsupported value 'yes'; set 0 or 1\n",
        ),
    ] {
        let program = Program::new();
        let arguments = ["bridge", "--model", "OAK-D-Pro-PoE", "--depth", "/camera/depth"];
        let ended = program.command(&arguments).env(name, value).output().unwrap();
        assert_eq!(ended.status.code(), Some(2));
        assert_eq!(String::from_utf8_lossy(&ended.stderr), expected);
    }
}
