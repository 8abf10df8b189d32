//! Mechanisms, procedures, jumps in time.

mod busy_loop;
mod endless_loop;
mod nested_raster;
mod raster_end;
mod recursion;
mod timer_outside_raster;
mod wait_outside_sequence;

pub use busy_loop::BUSY_LOOP;
pub use endless_loop::ENDLESS_LOOP;
pub use nested_raster::NESTED_RASTER;
pub use raster_end::RASTER_END;
pub use recursion::RECURSION;
pub use timer_outside_raster::TIMER_OUTSIDE_RASTER;
pub use wait_outside_sequence::WAIT_OUTSIDE_SEQUENCE;
