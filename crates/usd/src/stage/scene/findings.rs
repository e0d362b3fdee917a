use std::collections::BTreeMap;

use oaktwin_base::diagnostic::{Finding, Level, Message};

/// The maximum number of findings with the same code; more are only counted.
const MAX_PER_CODE: usize = 20;

/// Collects findings, a bounded number per code.
#[derive(Default)]
pub(in crate::stage) struct Findings {
    list: Vec<Entry>,
    counts: BTreeMap<&'static str, usize>,
}

enum Entry {
    Known(Finding),
    /// Those about the mesh with this index, which is not triangulated yet.
    OfMesh(u32),
}

impl Findings {
    /// Adds a warning.
    pub(in crate::stage) fn warn(
        &mut self,
        code: &'static str,
        place: &str,
        message: impl Into<Message>,
        remedy: &str,
    ) {
        self.push(Finding::new(code, Level::Warning, place, message, remedy));
    }

    /// Adds a finding.
    pub(in crate::stage) fn push(&mut self, finding: Finding) {
        let count = self.counts.entry(finding.code).or_default();
        *count += 1;
        if *count <= MAX_PER_CODE {
            self.list.push(Entry::Known(finding));
        }
    }

    /// Reserves the place of the findings about a mesh.
    pub(in crate::stage) fn reserve(&mut self, mesh: u32) {
        self.list.push(Entry::OfMesh(mesh));
    }

    /// Fills the reserved places.
    pub(in crate::stage) fn fill(&mut self, mut of_meshes: BTreeMap<u32, Vec<Finding>>) {
        let all = std::mem::take(self);
        let mut omitted = all.counts;
        for entry in all.list {
            match entry {
                Entry::Known(finding) => {
                    if let Some(count) = omitted.get_mut(finding.code) {
                        *count -= 1;
                    }
                    self.push(finding);
                }
                Entry::OfMesh(mesh) => {
                    for finding in of_meshes.remove(&mesh).unwrap_or_default() {
                        self.push(finding);
                    }
                }
            }
        }
        for (code, count) in omitted {
            *self.counts.entry(code).or_default() += count;
        }
    }

    /// Returns the findings, and for each code with too many a finding with the number of omitted ones.
    pub(in crate::stage) fn into_list(self) -> Vec<Finding> {
        let known = self.list.into_iter().filter_map(|entry| match entry {
            Entry::Known(finding) => Some(finding),
            Entry::OfMesh(_) => None,
        });
        let mut list: Vec<Finding> = known.collect();
        for (code, count) in self.counts {
            if let Some(more) = count.checked_sub(MAX_PER_CODE)
                && more > 0
            {
                list.push(Finding::new(
                    code,
                    Level::Warning,
                    "stage",
                    format!("{more} more of this kind"),
                    "",
                ));
            }
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finding(code: &'static str, place: &str) -> Finding {
        Finding::new(code, Level::Warning, place, "", "")
    }

    #[test]
    fn findings_about_meshes_have_their_place_and_are_counted() {
        let mut direct = Findings::default();
        let mut deferred = Findings::default();
        let mut of_meshes = BTreeMap::new();
        for mesh in 0..30_u32 {
            let (early, late) = (format!("early {mesh}"), format!("late {mesh}"));
            for findings in [&mut direct, &mut deferred] {
                findings.push(finding("a", &early));
            }
            let own = vec![finding("a", &late), finding("b", &late)];
            own.iter().cloned().for_each(|finding| direct.push(finding));
            deferred.reserve(mesh);
            of_meshes.insert(mesh, own);
        }
        deferred.fill(of_meshes);
        let list = deferred.into_list();
        assert_eq!(list, direct.into_list());
        assert_eq!(list.len(), 2 * MAX_PER_CODE + 2);
        assert_eq!(list[1].place, "late 0");
    }
}
