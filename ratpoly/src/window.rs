//! Multiplication in slices: a dense window of accumulators instead of a heap.
//!
//! The fields of a monomial are split: the leading ones name a slice of the product, the others an index
//! in mixed radix, which is the position of a cell in a window. The terms of each factor fall into groups
//! of equal leading fields; a slice of the product is the sum over the pairs of groups whose names add up
//! to its own, gathered in the window and then read out in descending order. The window of one slice
//! fits a cache, which no array for the whole product would. A bitmap marks the touched cells where
//! they are few. (Dense arrays with Kronecker indices: Moenck 1976; the chunked form: FLINT's `mul_array`
//! documentation.)

use crate::accumulator::{Accumulator, ProductsOf};
use crate::coefficient::Coefficient;
use crate::error::{Error, Resource};
use crate::layout::Layout;
use crate::packed::PackedMonomial;
use crate::terms::{Term, TermList};

/// The most cells of a window.
const MAX_CELLS: u64 = 1 << 20;

/// How the fields of a product are split, and how its cells are numbered.
#[derive(Debug, Clone)]
pub(crate) struct Plan {
    /// The fields from here on index the window.
    split: usize,
    /// For each field the least values in both factors.
    least: [Vec<u64>; 2],
    /// For each field the number of values in the product.
    range: Vec<u64>,
    /// For each field the step of the index: of the slice's name before the split, of the cell after it.
    stride: Vec<u64>,
    cells: usize,
    /// The number of names, if slices are few enough to be counted.
    names: u64,
}

impl Plan {
    /// The plan with the least estimated cost for factors of these shapes and cells of so many bytes;
    /// `None` if sorting all products is estimated cheaper.
    pub fn best(f: Shape, g: Shape, cell_bytes: usize) -> Option<Plan> {
        let fields = f.least.len();
        let range: Vec<u64> = (0..fields).map(|k| f.range(k) + g.range(k) - 1).collect();
        let products = f.terms as f64 * g.terms as f64;
        // Nanoseconds, roughly; only the comparison counts.
        let mut best = (products * products.log2() * 1.3, None);
        for split in 0..fields {
            let cells = range[split..]
                .iter()
                .try_fold(1u64, |n, r| n.checked_mul(*r));
            let names = range[..split]
                .iter()
                .try_fold(1u64, |n, r| n.checked_mul(*r));
            let (Some(cells), Some(names)) = (cells.filter(|c| *c <= MAX_CELLS), names) else {
                continue;
            };
            let pairs = f.groups[split] as f64 * g.groups[split] as f64;
            let slices = pairs.min(names as f64);
            let bytes = cells as f64 * cell_bytes as f64;
            let access = if bytes <= 40e3 {
                0.8
            } else if bytes <= 1.5e6 {
                1.6
            } else {
                4.0
            };
            let scan = (slices * cells as f64 / 100.0).min(products * 4.0) + cells as f64;
            let cost = products * access + pairs * 9.0 + scan;
            if cost < best.0 {
                best = (cost, Some((split, cells, names)));
            }
        }
        let (split, cells, names) = best.1?;
        let mut stride = vec![1; fields];
        for k in (0..fields - 1).rev() {
            stride[k] = if k + 1 == split {
                1
            } else {
                stride[k + 1] * range[k + 1]
            };
        }
        let least = [f.least, g.least];
        Some(Plan {
            split,
            least,
            range,
            stride,
            cells: cells as usize,
            names,
        })
    }

    /// The monomial with the fields of a cell after the split, and zeros before.
    fn low<M: PackedMonomial>(&self, layout: &Layout, cell: usize) -> M {
        M::from_fields(layout, |k| {
            if k < self.split {
                return 0;
            }
            self.least[0][k] + self.least[1][k] + cell as u64 / self.stride[k] % self.range[k]
        })
    }
}

/// What a plan needs to know of a factor.
pub(crate) struct Shape {
    terms: usize,
    least: Vec<u64>,
    greatest: Vec<u64>,
    /// For each split the number of groups with equal leading fields.
    groups: Vec<usize>,
}

impl Shape {
    pub fn of<M: PackedMonomial>(
        monomials: &mut dyn ExactSizeIterator<Item = &M>,
        layout: &Layout,
    ) -> Self {
        let fields = layout.fields;
        let terms = monomials.len();
        let (mut least, mut greatest) = (vec![u64::MAX; fields], vec![0; fields]);
        // A new group begins for every split after the first field that differs.
        let mut breaks = vec![0; fields];
        let mut previous = vec![u64::MAX; fields];
        for monomial in monomials {
            let mut differs = fields;
            for k in (0..fields).rev() {
                let value = monomial.field(layout, k);
                least[k] = least[k].min(value);
                greatest[k] = greatest[k].max(value);
                if value != previous[k] {
                    differs = k;
                    previous[k] = value;
                }
            }
            if differs < fields {
                breaks[differs] += 1;
            }
        }
        let mut groups = vec![1; fields];
        let mut count = 0;
        for split in 1..fields {
            count += breaks[split - 1];
            groups[split] = count;
        }
        Shape {
            terms,
            least,
            greatest,
            groups,
        }
    }

    fn range(&self, field: usize) -> u64 {
        self.greatest[field] - self.least[field] + 1
    }
}

/// The monomials of a factor by groups.
struct Groups<M> {
    /// The index in the window for each term.
    index: Vec<u32>,
    groups: Vec<Group>,
    /// The leading fields of each group, zeros after the split.
    heads: Vec<M>,
}

/// Terms with equal leading fields, their indices descending.
struct Group {
    name: u64,
    start: usize,
    end: usize,
}

impl<M: PackedMonomial> Groups<M> {
    fn new(
        monomials: &mut dyn ExactSizeIterator<Item = &M>,
        layout: &Layout,
        plan: &Plan,
        least: &[u64],
    ) -> Self {
        let index = Vec::with_capacity(monomials.len());
        let mut all = Groups {
            index,
            groups: Vec::new(),
            heads: Vec::new(),
        };
        let number = |m: &M, fields: std::ops::Range<usize>| -> u64 {
            fields
                .map(|k| (m.field(layout, k) - least[k]) * plan.stride[k])
                .sum()
        };
        for (position, m) in monomials.enumerate() {
            let name = number(m, 0..plan.split);
            if all.groups.last().is_none_or(|g: &Group| g.name != name) {
                let head = |k| {
                    if k < plan.split {
                        m.field(layout, k)
                    } else {
                        0
                    }
                };
                all.heads.push(M::from_fields(layout, head));
                all.groups.push(Group {
                    name,
                    start: position,
                    end: position,
                });
            }
            all.groups.last_mut().expect("just pushed").end = position + 1;
            all.index.push(number(m, plan.split..layout.fields) as u32);
        }
        all
    }
}

/// A factor as the window sees it: indices and coefficients of all terms, and the groups.
struct Factor<'a, C> {
    index: &'a [u32],
    coefficients: Vec<C>,
    groups: &'a [Group],
}

/// The product by a plan.
pub(crate) fn multiply<M: PackedMonomial, C: Coefficient, A: ProductsOf<C>>(
    f: &[Term<M, C>],
    g: &[Term<M, C>],
    layout: &Layout,
    plan: &Plan,
    most_terms: usize,
) -> Result<TermList<M>, Error> {
    let monomials = |terms: &[Term<M, C>], k: usize| {
        Groups::new(
            &mut terms.iter().map(|t| &t.monomial),
            layout,
            plan,
            &plan.least[k],
        )
    };
    let coefficients = |terms: &[Term<M, C>]| terms.iter().map(|t| t.coefficient.clone()).collect();
    let (a, b) = (monomials(f, 0), monomials(g, 1));
    let (f, g) = (
        Factor {
            index: &a.index,
            coefficients: coefficients(f),
            groups: &a.groups,
        },
        Factor {
            index: &b.index,
            coefficients: coefficients(g),
            groups: &b.groups,
        },
    );
    let pairs = pairs_by_slice(&a.groups, &b.groups, plan.names);
    let mut window = Window::<A>::new(plan.cells);
    let mut list = TermList::new();
    // Decoding a cell costs some divisions: with many products a table is cheaper.
    let table: Option<Vec<M>> = (f.index.len() * g.index.len() > 2 * plan.cells)
        .then(|| (0..plan.cells).map(|cell| plan.low(layout, cell)).collect());
    for slice in pairs.chunk_by(|a, b| a.name == b.name) {
        window.gather(slice, &f, &g);
        let head = a.heads[slice[0].i as usize].product(&b.heads[slice[0].j as usize]);
        window.drain(|cell, sum| {
            let monomial = match &table {
                Some(table) => head.product(&table[cell]),
                None => head.product(&plan.low(layout, cell)),
            };
            sum.append(monomial, &mut list);
        });
        if list.len() > most_terms {
            return Err(Error::BudgetExceeded(Resource::Terms));
        }
    }
    Ok(list)
}

/// A pair of groups and the name of the slice to which their product belongs.
struct Pair {
    name: u64,
    i: u32,
    j: u32,
}

/// All pairs of groups, by descending name of their slice.
fn pairs_by_slice(f: &[Group], g: &[Group], names: u64) -> Vec<Pair> {
    let count = f.len() * g.len();
    let all = || {
        f.iter().enumerate().flat_map(|(i, a)| {
            g.iter().enumerate().map(move |(j, b)| Pair {
                name: a.name + b.name,
                i: i as u32,
                j: j as u32,
            })
        })
    };
    if names > 4 * count as u64 + 1024 {
        let mut pairs: Vec<Pair> = all().collect();
        pairs.sort_by_key(|pair| std::cmp::Reverse(pair.name));
        return pairs;
    }
    // Few names: count, then place.
    let mut position = vec![0usize; names as usize + 1];
    for pair in all() {
        position[(names - pair.name) as usize] += 1;
    }
    for k in 1..position.len() {
        position[k] += position[k - 1];
    }
    let mut pairs: Vec<Pair> = (0..count)
        .map(|_| Pair {
            name: 0,
            i: 0,
            j: 0,
        })
        .collect();
    for pair in all() {
        let slot = &mut position[(names - 1 - pair.name) as usize];
        let place = *slot;
        *slot += 1;
        pairs[place] = pair;
    }
    pairs
}

/// Cells for the sums of one slice; all are zero and unmarked between slices.
struct Window<A> {
    cells: Vec<A>,
    marks: Vec<u64>,
    /// The cells from `lowest` to `highest` may be in use.
    lowest: usize,
    highest: usize,
    /// Whether used cells are marked; else all between are looked at.
    marked: bool,
}

impl<A: Accumulator> Window<A> {
    fn new(cells: usize) -> Self {
        Window {
            cells: vec![A::ZERO; cells],
            marks: vec![0; cells.div_ceil(64)],
            lowest: 0,
            highest: 0,
            marked: false,
        }
    }

    /// Adds the products of the pairs of groups of one slice.
    fn gather<C>(&mut self, slice: &[Pair], f: &Factor<C>, g: &Factor<C>)
    where
        A: ProductsOf<C>,
    {
        (self.lowest, self.highest) = (usize::MAX, 0);
        let mut products = 0;
        for pair in slice {
            let (a, b) = (&f.groups[pair.i as usize], &g.groups[pair.j as usize]);
            products += (a.end - a.start) * (b.end - b.start);
            let highest = f.index[a.start] + g.index[b.start];
            let lowest = f.index[a.end - 1] + g.index[b.end - 1];
            self.highest = self.highest.max(highest as usize);
            self.lowest = self.lowest.min(lowest as usize);
        }
        self.marked = products * 4 < self.highest - self.lowest;
        for pair in slice {
            let (a, b) = (&f.groups[pair.i as usize], &g.groups[pair.j as usize]);
            let (ai, ac) = (&f.index[a.start..a.end], &f.coefficients[a.start..a.end]);
            let (bi, bc) = (&g.index[b.start..b.end], &g.coefficients[b.start..b.end]);
            if ai.len() <= bi.len() {
                self.add_products(ai, ac, bi, bc);
            } else {
                self.add_products(bi, bc, ai, ac);
            }
        }
    }

    /// Adds all products of two rows of terms, the shorter first.
    #[inline]
    fn add_products<C>(&mut self, ai: &[u32], ac: &[C], bi: &[u32], bc: &[C])
    where
        A: ProductsOf<C>,
    {
        for (&base, a) in ai.iter().zip(ac) {
            let cells = &mut self.cells[base as usize..];
            for (&index, b) in bi.iter().zip(bc) {
                cells[index as usize].add_product(a, b);
            }
            if self.marked {
                for &index in bi {
                    let cell = (base + index) as usize;
                    self.marks[cell / 64] |= 1 << (cell % 64);
                }
            }
        }
    }

    /// Hands out the nonzero sums from the highest cell down and clears the window.
    #[inline]
    fn drain(&mut self, mut f: impl FnMut(usize, A)) {
        if !self.marked {
            for cell in (self.lowest..=self.highest).rev() {
                if !self.cells[cell].is_zero() {
                    f(cell, std::mem::replace(&mut self.cells[cell], A::ZERO));
                }
            }
            return;
        }
        for word in (self.lowest / 64..=self.highest / 64).rev() {
            let mut marks = std::mem::take(&mut self.marks[word]);
            while marks != 0 {
                let bit = 63 - marks.leading_zeros() as usize;
                marks ^= 1 << bit;
                let cell = word * 64 + bit;
                let sum = std::mem::replace(&mut self.cells[cell], A::ZERO);
                if !sum.is_zero() {
                    f(cell, sum);
                }
            }
        }
    }
}
