//! Tests side by side, results in their order.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;

/// Does `work` for each item on so many threads, and tells each result in the order of the items as soon as all
/// before it are told.
pub(super) fn each<T: Sync, R: Send>(
    items: &[T],
    jobs: NonZeroUsize,
    work: impl Fn(&T) -> R + Sync,
    mut tell: impl FnMut(&T, &R),
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    let mut results: Vec<Option<R>> = items.iter().map(|_| None).collect();
    std::thread::scope(|scope| {
        for _ in 0..jobs.get().min(items.len()) {
            let (sender, next, work) = (sender.clone(), &next, &work);
            scope.spawn(move || {
                while let Some((number, item)) = {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    items.get(number).map(|item| (number, item))
                } {
                    if sender.send((number, work(item))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        let mut told = 0;
        for (number, result) in receiver {
            results[number] = Some(result);
            while let Some((item, Some(result))) = items.get(told).zip(results.get(told).map(Option::as_ref))
            {
                tell(item, result);
                told += 1;
            }
        }
    });
    results.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_items_whatever_the_threads_do() {
        let items: Vec<u64> = (0..50).collect();
        for jobs in [1, 3, 200] {
            let mut told = Vec::new();
            let work = |n: &u64| {
                std::thread::sleep(std::time::Duration::from_micros(50 * (n * 7 % 5)));
                n * n
            };
            let results =
                each(&items, NonZeroUsize::new(jobs).unwrap(), work, |n, square| told.push((*n, *square)));
            assert_eq!(results, items.iter().map(|n| n * n).collect::<Vec<_>>());
            assert_eq!(told, items.iter().map(|n| (*n, n * n)).collect::<Vec<_>>(), "{jobs} threads");
        }
        assert_eq!(each(&[], NonZeroUsize::MIN, |(): &()| 1, |(), _| {}), Vec::<i32>::new());
    }
}
