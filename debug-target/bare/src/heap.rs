//! The memory the library works in: one piece, given by the host.

use core::panic::PanicInfo;

use linked_list_allocator::LockedHeap;

#[global_allocator]
static HEAP: LockedHeap = LockedHeap::empty();

/// Gives the library its memory; false when it has some already, or when this is too little to begin with.
///
/// # Safety
/// `memory` points to `len` bytes that nobody else uses from now on.
pub(crate) unsafe fn give(memory: *mut u8, len: usize) -> bool {
    /// Less than this cannot even hold the allocator's own notes.
    const LEAST: usize = 1024;
    let mut heap = HEAP.lock();
    if memory.is_null() || len < LEAST || heap.size() != 0 {
        return false;
    }
    // SAFETY: the caller promises the memory, and it is given once.
    unsafe { heap.init(memory, len) };
    true
}

/// Bytes in use.
pub(crate) fn used() -> usize {
    HEAP.lock().used()
}

unsafe extern "C" {
    /// Given by the host; see `technol.h`.
    fn technol_panicked() -> !;
}

/// Reached when memory runs out while a program is loaded, or by a mistake in this library.
#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    // SAFETY: a function without arguments that does not come back.
    unsafe { technol_panicked() }
}

/// What `core` and `alloc` are delivered with was made for unwinding and names this function. It is never called, since
/// here a panic ends everything.
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}
