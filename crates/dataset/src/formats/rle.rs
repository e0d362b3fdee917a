use crate::ObjectMask;

/// Returns the run lengths of a mask in an image, column by column, beginning with the pixels outside it.
pub(super) fn runs(mask: &ObjectMask, width: u32, height: u32) -> Vec<u32> {
    let (mut runs, mut run, mut inside) = (Vec::new(), 0, false);
    let [left, top] = mask.origin;
    let [across, down] = mask.size;
    let mut push = |is_inside: bool, length: u32| {
        if length == 0 || is_inside == inside {
            run += length;
        } else {
            runs.push(run);
            (run, inside) = (length, is_inside);
        }
    };
    push(false, left.min(width) * height);
    for x in left..(left + across).min(width) {
        push(false, top);
        for y in top..(top + down).min(height) {
            push(mask.contains(x, y), 1);
        }
        push(false, height.saturating_sub(top + down));
    }
    push(false, width.saturating_sub(left + across) * height);
    runs.push(run);
    runs
}

/// Returns run lengths as the text of COCO's compressed format: differences to the run before the last one, in groups of 5 bits.
pub(super) fn compressed(runs: &[u32]) -> String {
    let mut text = String::new();
    for (at, run) in runs.iter().enumerate() {
        let mut left = i64::from(*run);
        if at > 2 {
            left -= i64::from(runs[at - 2]);
        }
        loop {
            let group = left & 31;
            left >>= 5;
            let more = if group & 16 != 0 { left != -1 } else { left != 0 };
            let code = group | if more { 32 } else { 0 };
            text.push(char::from(u8::try_from(code + 48).unwrap_or(b'0')));
            if !more {
                break;
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_cover_the_image() {
        let mask = ObjectMask::of(6, 4, |x, y| (x == 2 && (1..3).contains(&y)) || (x == 3 && y == 1));
        assert_eq!(runs(&mask, 6, 4), [9, 2, 2, 1, 10]);
        assert_eq!(runs(&ObjectMask::default(), 6, 4), [24]);
        let all = ObjectMask::of(3, 2, |_, _| true);
        assert_eq!(runs(&all, 3, 2), [0, 6]);
    }

    #[test]
    fn compresses_as_coco_does() {
        // From the counts that COCO's own tools print for these runs; the oracle tests read whole data sets with them.
        assert_eq!(compressed(&[9, 2, 2, 1, 10]), "922O8");
        assert_eq!(compressed(&[24]), "h0");
    }
}
