use crate::raw::*;
use crate::{text, Chunk, Error};
use std::time::Duration;

/// Coordinates count chunks of the level of detail, 0 to 6.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ChunkKey {
    pub x: i32,
    pub y: i32,
    pub z: i32,
    pub level: u32,
}

#[derive(Clone, Debug)]
pub struct ReceivedChunk {
    pub key: ChunkKey,
    /// 0: as generated; higher is newer.
    pub revision: u64,
    /// XXH3-128 of the voxels.
    pub hash: u128,
    /// The material of all voxels, if they have one.
    pub uniform: Option<u16>,
    pub chunk: Chunk,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EditOutcome {
    /// Of the world after the edit.
    pub revision: u64,
    /// Voxels that the edit changed; 0: they already had these materials.
    pub changed: u32,
}

/// See the events of the same names in talus.h.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Event {
    Joined,
    Chunk(ReceivedChunk),
    ChunkLeft(ChunkKey),
    ViewComplete,
    /// Without a chunk: unchanged since the known hash.
    ChunkAnswer {
        request: u32,
        result: Result<Option<ReceivedChunk>, Error>,
    },
    /// 1/256 voxel above y = 0, one a column.
    Heights {
        request: u32,
        result: Result<Vec<i32>, Error>,
    },
    Pong {
        request: u32,
        result: Result<Duration, Error>,
    },
    Edited {
        request: u32,
        result: Result<EditOutcome, Error>,
    },
    Error(Error),
    Reconnecting(Error),
    Reconnected,
    Closed(Error),
    /// The type of an event that a newer libtalus has.
    Other(u32),
}

impl Event {
    /// # Safety
    /// The event is the last one of its client, so its pointers are valid.
    pub(crate) unsafe fn from_raw(event: &talus_event) -> Self {
        let request = event.request;
        let key = ChunkKey { x: event.x, y: event.y, z: event.z, level: event.level };
        let received = || {
            Chunk::retain(event.chunk).map(|chunk| ReceivedChunk {
                key,
                revision: event.revision,
                hash: (u128::from(event.hash_high) << 64) | u128::from(event.hash_low),
                uniform: u16::try_from(event.uniform_material).ok(),
                chunk,
            })
        };
        let retry_after = Duration::from_millis(event.retry_after_ms.into());
        let error = || Error { status: event.status, message: text(event.message), retry_after };
        let failed = event.status < 0;
        match event.type_ {
            TALUS_EVENT_JOINED => Self::Joined,
            TALUS_EVENT_CHUNK => received().map_or(Self::Other(event.type_), Self::Chunk),
            TALUS_EVENT_CHUNK_LEFT => Self::ChunkLeft(key),
            TALUS_EVENT_VIEW_COMPLETE => Self::ViewComplete,
            TALUS_EVENT_CHUNK_ANSWER => {
                Self::ChunkAnswer { request, result: if failed { Err(error()) } else { Ok(received()) } }
            }
            TALUS_EVENT_HEIGHTS => {
                let heights = || std::slice::from_raw_parts(event.heights_fx, event.column_count as usize).to_vec();
                Self::Heights { request, result: if failed { Err(error()) } else { Ok(heights()) } }
            }
            TALUS_EVENT_PONG => {
                let round_trip = Duration::from_nanos(event.round_trip_ns);
                Self::Pong { request, result: if failed { Err(error()) } else { Ok(round_trip) } }
            }
            TALUS_EVENT_EDITED => {
                let outcome = EditOutcome { revision: event.revision, changed: event.changed_voxels };
                Self::Edited { request, result: if failed { Err(error()) } else { Ok(outcome) } }
            }
            TALUS_EVENT_ERROR => Self::Error(error()),
            TALUS_EVENT_RECONNECTING => Self::Reconnecting(error()),
            TALUS_EVENT_RECONNECTED => Self::Reconnected,
            TALUS_EVENT_CLOSED => Self::Closed(error()),
            other => Self::Other(other),
        }
    }
}
