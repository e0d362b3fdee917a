//! Builds small glTF files.

use crate::support::floats;

/// A glTF file in construction: JSON members, and the bytes that accessors refer to.
#[derive(Clone, Default)]
pub(crate) struct Builder {
    views: Vec<String>,
    accessors: Vec<String>,
    pub(crate) bytes: Vec<u8>,
    pub(crate) members: Vec<String>,
}

impl Builder {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    pub(crate) fn view(&mut self, bytes: &[u8], stride: Option<usize>) -> usize {
        while !self.bytes.len().is_multiple_of(4) {
            self.bytes.push(0);
        }
        let stride = stride
            .map(|stride| format!(r#","byteStride":{stride}"#))
            .unwrap_or_default();
        self.views.push(format!(
            r#"{{"buffer":0,"byteOffset":{},"byteLength":{}{stride}}}"#,
            self.bytes.len(),
            bytes.len()
        ));
        self.bytes.extend(bytes);
        self.views.len() - 1
    }

    pub(crate) fn accessor(&mut self, members: &str) -> usize {
        self.accessors.push(format!("{{{members}}}"));
        self.accessors.len() - 1
    }

    pub(crate) fn floats(&mut self, shape: &str, numbers: &[f32]) -> usize {
        let size = match shape {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "MAT4" => 16,
            _ => 4,
        };
        let view = self.view(&floats(numbers), None);
        let count = numbers.len() / size;
        self.accessor(&format!(
            r#""bufferView":{view},"componentType":5126,"count":{count},"type":"{shape}""#
        ))
    }

    pub(crate) fn shorts(&mut self, numbers: &[u16]) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|i| i.to_le_bytes()).collect();
        let view = self.view(&bytes, None);
        let count = numbers.len();
        self.accessor(&format!(
            r#""bufferView":{view},"componentType":5123,"count":{count},"type":"SCALAR""#
        ))
    }

    /// Adds a member of the root, such as `"nodes":[…]`.
    pub(crate) fn member(mut self, member: &str) -> Self {
        self.members.push(member.into());
        self
    }

    pub(crate) fn json(&self, buffer: &str) -> String {
        let list = |name: &str, list: &[String]| match list {
            [] => String::new(),
            _ => format!(r#","{name}":[{}]"#, list.join(",")),
        };
        let members: String = self.members.iter().map(|member| format!(",{member}")).collect();
        format!(
            r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}{buffer}}}]{}{}{members}}}"#,
            self.bytes.len(),
            list("bufferViews", &self.views),
            list("accessors", &self.accessors),
        )
    }

    pub(crate) fn with_uri(&self, uri: &str) -> String {
        self.json(&format!(r#","uri":"{uri}""#))
    }

    pub(crate) fn embedded(&self) -> String {
        let data: String = self.bytes.iter().map(|byte| format!("%{byte:02x}")).collect();
        self.with_uri(&format!("data:application/octet-stream,{data}"))
    }

    pub(crate) fn binary(&self) -> Vec<u8> {
        let mut json = self.json("").into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut bin = self.bytes.clone();
        bin.resize(bin.len().next_multiple_of(4), 0);
        let word = |size: usize| (size as u32).to_le_bytes();
        [
            b"glTF".as_slice(),
            &word(2),
            &word(28 + json.len() + bin.len()),
            &word(json.len()),
            b"JSON",
            &json,
            &word(bin.len()),
            b"BIN\0",
            &bin,
        ]
        .concat()
    }

    /// Adds a square of four points in the x-y plane with two triangles.
    pub(crate) fn square(&mut self) -> (usize, usize) {
        let positions = self.floats("VEC3", &[0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.]);
        (positions, self.shorts(&[0, 1, 2, 0, 2, 3]))
    }

    /// One mesh with a square in one node.
    pub(crate) fn simple() -> Self {
        let mut builder = Self::new();
        let (positions, indices) = builder.square();
        builder
            .member(&format!(
                r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":{positions}}},"indices":{indices}}}]}}]"#
            ))
            .member(r#""nodes":[{"mesh":0,"name":"it"}]"#)
    }

    /// A file with all supported features.
    pub(crate) fn everything() -> Self {
        let mut b = Self::new();
        let (positions, indices) = b.square();
        let normals = b.floats("VEC3", &[0., 0., 1., 0., 0., 1., 0., 0., 1., 0., 0., 1.]);
        let uvs = b.floats("VEC2", &[0., 0., 1., 0., 1., 1., 0., 1.]);
        let color_view = b.view(
            &[255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 51, 51, 51, 255],
            None,
        );
        let colors = b.accessor(&format!(
            r#""bufferView":{color_view},"componentType":5121,"normalized":true,"count":4,"type":"VEC4""#
        ));
        let sparse_at = b.view(&[2, 0], None);
        let sparse = b.view(&floats(&[5., 5., 5.]), None);
        let moved = b.accessor(&format!(
            r#""bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{{"count":1,"indices":{{"bufferView":{sparse_at},"componentType":5123}},"values":{{"bufferView":{sparse}}}}}"#
        ));
        let image = b.view(b"an image", None);
        b.member(&format!(
            r#""meshes":[{{"primitives":[
                {{"attributes":{{"POSITION":{positions},"NORMAL":{normals},"TEXCOORD_1":{uvs}}},"indices":{indices},"material":0}},
                {{"attributes":{{"POSITION":{moved},"COLOR_0":{colors}}},"mode":5,"material":1}},
                {{"attributes":{{"POSITION":{moved}}},"mode":1}}]}},
              {{"primitives":[{{"attributes":{{"POSITION":{positions}}},"mode":6}}]}}]"#
        ))
        .member(&format!(r#""images":[{{"bufferView":{image},"mimeType":"image/png","name":"picture"}}]"#))
        .member(r#""samplers":[{"wrapS":33071,"wrapT":33648}],"textures":[{"source":0,"sampler":0}]"#)
        .member(
            r#""materials":[
                {"name":"painted","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0,"roughnessFactor":0.75,
                 "baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.5,0],"scale":[2,4],"texCoord":1}}}}},
                {"doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1]},"emissiveFactor":[1,2,3]}]"#,
        )
        .member(r#""cameras":[{"type":"perspective","perspective":{"yfov":0.8,"aspectRatio":1.6,"znear":0.1}},
            {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":9,"znear":0}}]"#)
        .member(r#""extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[
            {"type":"directional","intensity":3,"color":[1,0.5,0]},{"type":"point","intensity":10},
            {"type":"spot","intensity":2,"spot":{}}]}}"#)
        .member(
            r#""nodes":[
                {"name":"root","children":[1,2,3,4,5,6,7],"translation":[10,0,0],"rotation":[0,0,0.70710678,0.70710678],"scale":[2,2,2]},
                {"name":"a","mesh":0},{"name":"a","mesh":0,"translation":[0,0,1]},
                {"name":"flat/fan","mesh":1,"matrix":[1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,7,1]},
                {"camera":0,"rotation":[0.70710678,0,0,0.70710678]},{"camera":1},
                {"extensions":{"KHR_lights_punctual":{"light":1}}},{"extensions":{"KHR_lights_punctual":{"light":2}}},
                {"extensions":{"KHR_lights_punctual":{"light":0}},"rotation":[-0.70710678,0,0,0.70710678]}],
              "scenes":[{"nodes":[0,8]}],"scene":0"#,
        )
    }
}
