//! Index lists: triangles that share edges and vertices with recent ones, and other sequences.

const TRIANGLES: u8 = 0xe1;
const SEQUENCE: u8 = 0xd1;

/// Decodes the corners of triangles, `count` in all.
pub(super) fn triangles(bytes: &[u8], count: usize) -> Option<Vec<u32>> {
    let codes = count / 3;
    let (codes, rest) = bytes.strip_prefix(&[TRIANGLES])?.split_at_checked(codes)?;
    let (data, table) = rest.split_at_checked(rest.len().checked_sub(16)?)?;
    if !count.is_multiple_of(3) {
        return None;
    }
    let mut state = IndexDecoder {
        data,
        next: 0,
        last: 0,
        edges: Recent::new([u32::MAX; 2]),
        vertices: Recent::new(u32::MAX),
    };
    let mut corners = Vec::with_capacity(count);
    for &code in codes {
        let triangle = match (code >> 4, code & 15) {
            (15, 14 | 15) => state.explicit(code & 1 == 0)?,
            (15, entry) => state.looked_up(table[usize::from(entry)]),
            (edge, corner) => state.adjacent(edge, corner)?,
        };
        corners.extend(triangle);
    }
    state.data.is_empty().then_some(corners)
}

/// Decodes a list of indices, each relative to one of two earlier ones.
pub(super) fn sequence(bytes: &[u8], count: usize) -> Option<Vec<u32>> {
    let data = bytes.strip_prefix(&[SEQUENCE])?;
    let mut data = data.get(..data.len().checked_sub(4)?)?;
    if count > data.len() {
        return None;
    }
    let mut last = [0_u32; 2];
    let mut indices = Vec::with_capacity(count);
    for _ in 0..count {
        let value = varint(&mut data)?;
        let baseline = &mut last[(value & 1) as usize];
        *baseline = baseline.wrapping_add(signed(value >> 1));
        indices.push(*baseline);
    }
    data.is_empty().then_some(indices)
}

/// Reads an unsigned LEB128 number of at most five bytes.
fn varint(data: &mut &[u8]) -> Option<u32> {
    let mut value = 0;
    for shift in (0..35).step_by(7) {
        let (&byte, rest) = data.split_first()?;
        *data = rest;
        value |= u32::from(byte & 127) << shift;
        if byte < 128 {
            return Some(value);
        }
    }
    None
}

/// Decodes a zigzag-encoded difference.
fn signed(value: u32) -> u32 {
    value >> 1 ^ (value & 1).wrapping_neg()
}

/// The last 16 values.
struct Recent<T> {
    values: [T; 16],
    next: usize,
}

impl<T: Copy> Recent<T> {
    fn new(value: T) -> Self {
        Self {
            values: [value; 16],
            next: 0,
        }
    }

    fn push(&mut self, value: T) {
        self.values[self.next] = value;
        self.next = (self.next + 1) % 16;
    }

    /// The value pushed before `age` others.
    fn get(&self, age: u8) -> T {
        self.values[(self.next + 31 - usize::from(age)) % 16]
    }
}

struct IndexDecoder<'a> {
    data: &'a [u8],
    /// The next unused index.
    next: u32,
    /// The last explicit index.
    last: u32,
    edges: Recent<[u32; 2]>,
    vertices: Recent<u32>,
}

impl IndexDecoder<'_> {
    /// A triangle at a recent edge.
    fn adjacent(&mut self, edge: u8, corner: u8) -> Option<[u32; 3]> {
        let [a, b] = self.edges.get(edge);
        let c = match corner {
            0 => self.unused(),
            13 => {
                self.last = self.last.wrapping_sub(1);
                self.last
            }
            14 => {
                self.last = self.last.wrapping_add(1);
                self.last
            }
            15 => self.difference()?,
            age => self.vertices.get(age),
        };
        if !(1..13).contains(&corner) {
            self.vertices.push(c);
        }
        self.edges.push([c, b]);
        self.edges.push([a, c]);
        Some([a, b, c])
    }

    /// A triangle with an unused vertex and two others that the table describes.
    fn looked_up(&mut self, entry: u8) -> [u32; 3] {
        let a = self.unused();
        let mut corner = |code: u8| match code {
            0 => self.unused(),
            age => self.vertices.get(age - 1),
        };
        let (b, c) = (corner(entry >> 4), corner(entry & 15));
        self.add([a, b, c], [true, entry >> 4 == 0, entry & 15 == 0])
    }

    /// A triangle whose corners have their own codes.
    fn explicit(&mut self, first_is_unused: bool) -> Option<[u32; 3]> {
        let (&codes, rest) = self.data.split_first()?;
        self.data = rest;
        if codes == 0 {
            self.next = 0;
        }
        let a = self.corner(if first_is_unused { 0 } else { 15 })?;
        let (b, c) = (self.corner(codes >> 4)?, self.corner(codes & 15)?);
        let is_new = |code: u8| code == 0 || code == 15;
        Some(self.add([a, b, c], [true, is_new(codes >> 4), is_new(codes & 15)]))
    }

    fn corner(&mut self, code: u8) -> Option<u32> {
        Some(match code {
            0 => self.unused(),
            15 => self.difference()?,
            age => self.vertices.get(age - 1),
        })
    }

    fn add(&mut self, [a, b, c]: [u32; 3], is_new: [bool; 3]) -> [u32; 3] {
        for edge in [[b, a], [c, b], [a, c]] {
            self.edges.push(edge);
        }
        for (vertex, is_new) in [a, b, c].into_iter().zip(is_new) {
            if is_new {
                self.vertices.push(vertex);
            }
        }
        [a, b, c]
    }

    fn unused(&mut self) -> u32 {
        let index = self.next;
        self.next = index.wrapping_add(1);
        index
    }

    fn difference(&mut self) -> Option<u32> {
        self.last = self.last.wrapping_add(signed(varint(&mut self.data)?));
        Some(self.last)
    }
}
