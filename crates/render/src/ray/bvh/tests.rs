use proptest::prelude::*;

use super::*;

/// Asserts that each item is in one leaf and inside all boxes above it, and returns the depth of the tree.
fn check(nodes: &[Node], items: &[Item], original: &[Bounds]) -> usize {
    let mut seen = vec![0; items.len()];
    let mut deepest = 0;
    let mut left = vec![(0usize, Vec::<([f32; 3], [f32; 3])>::new())];
    while let Some((index, above)) = left.pop() {
        let node = &nodes[index];
        for child in (0..8).filter(|child| !node.bounds[0][*child].is_nan()) {
            let plane = |i: usize| node.bounds[i][child];
            let mut above = above.clone();
            above.push(([plane(0), plane(1), plane(2)], [plane(3), plane(4), plane(5)]));
            let (first, count) = (node.first[child] as usize, usize::from(node.count[child]));
            assert!(count <= LEAF);
            if count == 0 {
                assert!(first > index);
                left.push((first, above));
                continue;
            }
            deepest = deepest.max(above.len());
            for at in first..first + count {
                seen[at] += 1;
                let item = original[items[at].index() as usize];
                for (min, max) in &above {
                    assert!(
                        (0..3).all(|axis| min[axis] <= item.min()[axis] && item.max()[axis] <= max[axis])
                    );
                }
            }
        }
    }
    assert!(seen.iter().all(|times| *times == 1));
    deepest
}

fn check_build(bounds: &[Bounds]) -> usize {
    let mut items: Vec<Item> = (0u32..)
        .zip(bounds)
        .map(|(index, b)| Item::new(*b, index))
        .collect();
    let nodes = build(&mut items, LEAF);
    check(&nodes, &items, bounds)
}

fn cube(at: [f32; 3], size: f32) -> Bounds {
    Bounds::new(at, at.map(|x| x + size))
}

proptest! {
    #[test]
    fn every_item_is_found_once(
        places in prop::collection::vec((prop::array::uniform3(-1e3f32..1e3), 0.0f32..10.0), 0..400)
    ) {
        let bounds: Vec<Bounds> = places.iter().map(|(at, size)| cube(*at, *size)).collect();
        check_build(&bounds);
    }
}

#[test]
fn coincident_boxes_give_a_shallow_tree() {
    let depth = check_build(&vec![cube([1.0, 2.0, 3.0], 0.5); 100_000]);
    assert!(depth <= 8, "{depth}");
}

#[test]
fn a_lattice_gives_a_shallow_tree() {
    let bounds: Vec<Bounds> = (0..60u16 * 60 * 10)
        .map(|i| {
            cube(
                [f32::from(i % 60), f32::from(i / 60 % 60), f32::from(i / 3600)],
                0.9,
            )
        })
        .collect();
    let depth = check_build(&bounds);
    assert!(depth <= 7, "{depth}");
}

#[test]
fn exponentially_growing_boxes_give_a_bounded_depth() {
    let mut bounds = Vec::new();
    let mut at = 1e-37f32;
    while at < 1e38 {
        bounds.extend([cube([at, -at, 0.0], at); 40]);
        at *= 2.0;
    }
    let depth = check_build(&bounds);
    assert!(depth <= 80, "{depth}");
}

#[test]
fn extreme_coordinates() {
    let bounds: Vec<Bounds> = (0..100u8)
        .map(|i| cube([f32::MAX * (f32::from(i) / 50.0 - 1.0), f32::MIN, 0.0], 0.0))
        .collect();
    check_build(&bounds);
}

#[test]
fn the_tree_does_not_depend_on_the_number_of_threads() {
    let bounds: Vec<Bounds> = (0..200_000u32)
        .map(|i| {
            let mix = |n: u32| (i.wrapping_mul(n) >> 12) as f32 / 1e3;
            cube([mix(2_654_435_761), mix(2_246_822_519), mix(3_266_489_917)], 0.5)
        })
        .collect();
    let grown = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let mut items: Vec<Item> = (0u32..)
            .zip(&bounds)
            .map(|(index, b)| Item::new(*b, index))
            .collect();
        let nodes = pool.install(|| build(&mut items, LEAF));
        let order: Vec<u32> = items.iter().map(Item::index).collect();
        (format!("{nodes:?}"), order)
    };
    assert!(grown(1) == grown(3));
}
