import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`牛顿定律 $\symf = \symM\syma$ 中的加速度在每一瞬间都有定义。计算机动画却和电影一样，由一帧帧画面组成，相邻两帧相隔
$\symdeltaT$，其间什么也没有记录。因此，速度和加速度只能由现有的量算出，这就是**位置**。`,
  differences: {
    title: '以差商代替导数',
    velocity: raw`质点 $i$ 的速度，等于它从上一帧到这一帧的位移除以所用的时间：

$$\symvelocity_i \approx \frac{\sympCurr_i - \sympPrev_i}{\symdeltaT}$$

加速度之于速度，正如速度之于位置。用下一步的速度减去上一步的速度，再除以 $\symdeltaT$：`,
    roles: raw`这个分式涉及三个时刻，它们的地位并不相同：

- $\sympPrev$ 和 $\sympCurr$ 是上一步与当前的位置，为**已知量**；
- $\symp$ 是 $\mathbf{p}^{t+\Delta t}$ 的简写，为一个时间步所要求解的**未知量**。

求出之后，三者依次前移：$\sympCurr$ 成为 $\sympPrev$，$\symp$ 成为 $\sympCurr$，随即开始下一步。速度无须另外存储。若场景从静止开始，则取
$\sympPrev = \sympCurr$。`,
  },
  swing: {
    caption: raw`弹簧末端的一个质点。圆圈是已知的 $\sympPrev$ 和 $\sympCurr$。若不受力，它将沿虚线再走同样远。箭头是力带来的偏离
$\symdeltaT^2\syma$，箭头所指即 $\symp$。请用最右边的按钮逐步前进，改变 $\symdeltaT$，或拖动质点。`,
    table: '质点 1：由三个位置求得',
  },
  size: {
    title: '时间步取多长？',
    ask: raw`$\symdeltaT$ 取多大合适？`,
    hint: raw`电影每秒放映多少帧？你面前的屏幕呢？`,
    answer: raw`取一帧画面停留的时间。电影每秒 24 帧，所以动画制作通常取 1/24 s；多数屏幕每秒刷新 60 次，追求流畅的游戏取 1/60 s，想节省计算时取
1/30 s。

步长越大，计算量越小，看到的也越少：取 1 s 时，整个摆动都落在两帧之间。代价还不止于此。挂在无摩擦钉子上的三角形本该永远摆动下去。让下面四个一起运动，
观察它们的能量，即动能与势能之和。`,
    seen: raw`模型中没有任何摩擦，四者的能量却都在减少，而且**步长越大，损失越多**。这种方法取时间步末端的力，总会带来一点阻尼。若改取始端的力，情形
可能正好相反，后果更糟，见[下一节](optimisation)。`,
    order: '步长缩短能改善多少：各方法的精度阶，见积分方法页面下方',
    name: 'Δt = {{delta_t}}',
    reading: 't = {{time}}\n能量 {{gained}}',
    energy: '相对于开始时的能量变化，J',
    time: '模拟时间，s',
    summary: '四种时间步长下能量随模拟时间的变化。曲线都在下降，步长越大，降得越多。',
  },
  sources: {
    jacobson:
      'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Mass-Spring Systems”一节，至加速度的差分为止。',
    liu: 'T. Liu、A. Bargteil、J. O’Brien、L. Kavan，Fast Simulation of Mass-Spring Systems，2013：第 3 节。',
    hairer: 'E. Hairer、C. Lubich、G. Wanner，Geometric Numerical Integration：第 I 章，数值方法对能量的影响。',
  },
};
