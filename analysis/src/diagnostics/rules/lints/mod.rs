//! Programs that can be built but hardly do what was meant.

mod analog_without_port;
mod axis_left_out;
mod buffer_too_short;
mod error_not_tested;
mod jump_decided_by_wait;
mod port_in_a_cell;
mod positioning_incomplete;
mod ramp_runs_once;
mod record_of_one_byte;
mod regulator_in_closed_loop;
mod result_not_awaited;
mod simulated_spindle_switched;
mod state_without_target;

pub use analog_without_port::ANALOG_WITHOUT_PORT;
pub use axis_left_out::AXIS_LEFT_OUT;
pub use buffer_too_short::BUFFER_TOO_SHORT;
pub use error_not_tested::ERROR_NOT_TESTED;
pub use jump_decided_by_wait::JUMP_DECIDED_BY_WAIT;
pub use port_in_a_cell::PORT_IN_A_CELL;
pub use positioning_incomplete::POSITIONING_INCOMPLETE;
pub use ramp_runs_once::RAMP_RUNS_ONCE;
pub use record_of_one_byte::RECORD_OF_ONE_BYTE;
pub use regulator_in_closed_loop::REGULATOR_IN_CLOSED_LOOP;
pub use result_not_awaited::RESULT_NOT_AWAITED;
pub use simulated_spindle_switched::SIMULATED_SPINDLE_SWITCHED;
pub use state_without_target::STATE_WITHOUT_TARGET;
