use crate::raw::*;

/// Voxels of a chunk.
pub const CHUNK_VOLUME: usize = TALUS_CHUNK_VOLUME as usize;

/// A chunk's immutable voxels. Clones share them; any thread may have one.
#[derive(Debug)]
pub struct Chunk(*const talus_chunk);

// talus.h: any thread may decode, retain and release a chunk.
unsafe impl Send for Chunk {}
unsafe impl Sync for Chunk {}

impl Chunk {
    /// Another owner of what an event points to.
    ///
    /// # Safety
    /// The pointer is NULL or that of a chunk.
    pub(crate) unsafe fn retain(chunk: *const talus_chunk) -> Option<Self> {
        if chunk.is_null() {
            return None;
        }
        talus_chunk_retain(chunk);
        Some(Self(chunk))
    }

    /// For functions of [`crate::raw`]; retain it to keep it longer than this.
    pub fn as_raw(&self) -> *const talus_chunk {
        self.0
    }

    /// Material ids, index `raw::TALUS_VOXEL_INDEX(x, y, z)`.
    pub fn decode(&self, voxels: &mut [u16; CHUNK_VOLUME]) {
        let status = unsafe { talus_decode(self.0, voxels.as_mut_ptr(), CHUNK_VOLUME) };
        // It was decoded when it came.
        assert_eq!(status, TALUS_OK, "libtalus could not write a chunk's voxels");
    }
}

impl Clone for Chunk {
    fn clone(&self) -> Self {
        unsafe { talus_chunk_retain(self.0) };
        Self(self.0)
    }
}

impl Drop for Chunk {
    fn drop(&mut self) {
        unsafe { talus_chunk_release(self.0) };
    }
}
