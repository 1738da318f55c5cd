use crate::raw::*;

/// An edit: if all guards hold, its writes and then its fills are applied, completely or not at all. Voxels are base voxels.
#[derive(Clone, Debug, Default)]
pub struct Edit {
    guard_voxels: Vec<[i64; 3]>,
    guard_materials: Vec<u16>,
    write_voxels: Vec<[i64; 3]>,
    write_materials: Vec<u16>,
    fill_corners: Vec<[[i64; 3]; 2]>,
    fill_materials: Vec<i32>,
}

impl Edit {
    /// Nothing is applied unless the voxel has this material.
    pub fn guard(mut self, voxel: [i64; 3], material: u16) -> Self {
        self.guard_voxels.push(voxel);
        self.guard_materials.push(material);
        self
    }

    pub fn write(mut self, voxel: [i64; 3], material: u16) -> Self {
        self.write_voxels.push(voxel);
        self.write_materials.push(material);
        self
    }

    /// A box, both corners included. Without a material: as generated.
    pub fn fill(mut self, lowest: [i64; 3], highest: [i64; 3], material: Option<u16>) -> Self {
        self.fill_corners.push([lowest, highest]);
        self.fill_materials.push(material.map_or(TALUS_AS_GENERATED, i32::from));
        self
    }

    /// Valid while self lives.
    pub(crate) fn raw(&self) -> talus_edit {
        talus_edit {
            guard_voxels: self.guard_voxels.as_ptr().cast(),
            guard_materials: self.guard_materials.as_ptr(),
            guard_count: self.guard_voxels.len() as u32,
            write_voxels: self.write_voxels.as_ptr().cast(),
            write_materials: self.write_materials.as_ptr(),
            write_count: self.write_voxels.len() as u32,
            fill_corners: self.fill_corners.as_ptr().cast(),
            fill_materials: self.fill_materials.as_ptr(),
            fill_count: self.fill_corners.len() as u32,
            ..talus_edit::default()
        }
    }
}
