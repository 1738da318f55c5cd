//! Client of the Talus voxel world server, by libtalus.
//!
//! [`Client`] and [`Chunk`] are safe. [`raw`] has all of libtalus, as its header `talus.h` documents it.
//!
//! ```no_run
//! use talus::{Client, Event, Options, View};
//!
//! let mut client = Client::new()?;
//! client.connect("localhost", 4780, &Options::default())?;
//! while let Some(event) = client.poll(10_000)? {
//!     match event {
//!         Event::Joined => {
//!             let spawn = client.world()?.spawn;
//!             client.set_view(&View { centre: spawn, horizontal_radius: 8, vertical_radius: 4, ..View::default() })?;
//!         }
//!         Event::Chunk(received) => println!("{:?}", received.key),
//!         Event::ViewComplete => break,
//!         Event::Closed(error) => return Err(error),
//!         _ => {}
//!     }
//! }
//! # Ok::<(), talus::Error>(())
//! ```

mod chunk;
mod client;
mod edit;
mod event;
#[path = "talus.rs"]
#[rustfmt::skip]
pub mod raw;

pub use chunk::{Chunk, CHUNK_VOLUME};
pub use client::{Client, Material, Options, View, World};
pub use edit::Edit;
pub use event::{ChunkKey, EditOutcome, Event, ReceivedChunk};

use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_char;
use std::time::Duration;

/// A status below 0, and one line that says why.
#[derive(Clone, Debug)]
pub struct Error {
    pub status: raw::talus_status,
    pub message: String,
    /// Delay that the server asks for; 0: no delay.
    pub retry_after: Duration,
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

/// A string of the library; empty for NULL.
///
/// # Safety
/// It ends in a zero, and lives until this returns.
unsafe fn text(text: *const c_char) -> String {
    if text.is_null() {
        return String::new();
    }
    CStr::from_ptr(text).to_string_lossy().into_owned()
}
