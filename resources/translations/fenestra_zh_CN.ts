<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>ClipTool</name>
    <message>
        <source>Crop</source>
        <translation>裁切</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>移动裁剪平面</translation>
    </message>
    <message>
        <source>Tilt the clip plane</source>
        <translation>倾斜裁剪平面</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Menu: %1</source>
        <translation>菜单：%1</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>按键与鼠标</translation>
    </message>
    <message>
        <source>What the mouse does in each view, then the keys of the menus.</source>
        <translation>鼠标在各视图中的作用，以及菜单的快捷键。</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source> (shader schedule: %1)</source>
        <translation> （着色器调度：%1）</translation>
    </message>
    <message>
        <source>About Fenestra</source>
        <translation>关于 Fenestra</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;A medical volume viewer that opens an adaptive cutaway around the structure you want to see.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not for diagnostic use.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. It comes with no warranty.&lt;/p&gt;&lt;p&gt;3-D views: %2&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;一款医学体数据查看器，可围绕目标结构打开自适应剖切。&lt;/p&gt;&lt;p&gt;&lt;b&gt;不得用于诊断。&lt;/b&gt;&lt;/p&gt;&lt;p&gt;自由软件，遵循 GNU 通用公共许可证第 3 版或更高版本，不提供任何担保。&lt;/p&gt;&lt;p&gt;三维视图：%2&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>层面</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>crosshair; the label there, or the region around the place, becomes the focus</source>
        <translation>定位十字线；该处的标签或周围区域成为焦点</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+单击</translation>
    </message>
    <message>
        <source>the label joins or leaves the focus</source>
        <translation>标签加入或移出焦点</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>拖动</translation>
    </message>
    <message>
        <source>window width (across) and level (up and down)</source>
        <translation>窗宽（水平）与窗位（垂直）</translation>
    </message>
    <message>
        <source>Ctrl+double-click</source>
        <translation>Ctrl+双击</translation>
    </message>
    <message>
        <source>window and level of the data</source>
        <translation>数据自带的窗宽窗位</translation>
    </message>
    <message>
        <source>Wheel, arrows</source>
        <translation>滚轮、方向键</translation>
    </message>
    <message>
        <source>next and previous slices</source>
        <translation>下一层与上一层</translation>
    </message>
    <message>
        <source>Page up, Page down</source>
        <translation>Page Up、Page Down</translation>
    </message>
    <message>
        <source>ten slices</source>
        <translation>十个层面</translation>
    </message>
    <message>
        <source>Measures, on the slices</source>
        <translation>测量（层面上）</translation>
    </message>
    <message>
        <source>Drag, or clicks</source>
        <translation>拖动或单击</translation>
    </message>
    <message>
        <source>Drag a handle or line</source>
        <translation>拖动端点或线</translation>
    </message>
    <message>
        <source>move the end, or the measure</source>
        <translation>移动端点或整个测量</translation>
    </message>
    <message>
        <source>Right click on it</source>
        <translation>右键单击测量</translation>
    </message>
    <message>
        <source>Clipping, while its tab is in sight</source>
        <translation>裁剪（其选项卡可见时）</translation>
    </message>
    <message>
        <source>Drag a square</source>
        <translation>拖动方块</translation>
    </message>
    <message>
        <source>move a face of the box, or a plane</source>
        <translation>移动裁剪框的面或平面</translation>
    </message>
    <message>
        <source>Drag the ball at an arrow</source>
        <translation>拖动箭头处的球</translation>
    </message>
    <message>
        <source>tilt the plane</source>
        <translation>倾斜平面</translation>
    </message>
    <message>
        <source>Walls of slices, in the 3-D views</source>
        <translation>层面墙（三维视图中）</translation>
    </message>
    <message>
        <source>move the slice of that colour</source>
        <translation>移动该颜色的层面</translation>
    </message>
    <message>
        <source>3-D views</source>
        <translation>三维视图</translation>
    </message>
    <message>
        <source>Drag, arrows</source>
        <translation>拖动、方向键</translation>
    </message>
    <message>
        <source>rotate; the linked view follows</source>
        <translation>旋转；联动视图随之转动</translation>
    </message>
    <message>
        <source>crosshair to what is seen there; its label or region becomes the focus</source>
        <translation>十字线定位到所见处；其标签或区域成为焦点</translation>
    </message>
    <message>
        <source>its label joins or leaves the focus</source>
        <translation>其标签加入或移出焦点</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>A grown region, in all views</source>
        <translation>生长区域（所有视图）</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Shift+单击</translation>
    </message>
    <message>
        <source>add what is there to the region</source>
        <translation>将该处加入区域</translation>
    </message>
    <message>
        <source>take what is there away from the region</source>
        <translation>将该处移出区域</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Shift+拖动</translation>
    </message>
    <message>
        <source>draw a ball around a structure: the region that grows there stays within it</source>
        <translation>围绕结构画球：在该处生长的区域不会超出此球</translation>
    </message>
    <message>
        <source>Alt+wheel</source>
        <translation>Alt+滚轮</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>回车</translation>
    </message>
    <message>
        <source>open the 3-D views to a large or doubtful region, which asks before</source>
        <translation>让三维视图向先行询问的过大或存疑区域开口</translation>
    </message>
    <message>
        <source>Painting the region, in all views</source>
        <translation>绘制区域（所有视图）</translation>
    </message>
    <message>
        <source>add what the ball passes over</source>
        <translation>添加球经过之处</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>移除球经过之处</translation>
    </message>
    <message>
        <source>Brush, in the 3-D views</source>
        <translation>画笔（三维视图中）</translation>
    </message>
    <message>
        <source>paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+拖动</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Shift+wheel, Shift+drag</source>
        <translation>Shift+滚轮、Shift+拖动</translation>
    </message>
    <message>
        <source>depth, or by how much the context&apos;s edges change</source>
        <translation>深度，或周围组织边缘的变化量</translation>
    </message>
    <message>
        <source>Carving, in all views</source>
        <translation>雕刻（所有视图）</translation>
    </message>
    <message>
        <source>remove what lies along it, once the button is let go</source>
        <translation>松开按键后移除沿途组织</translation>
    </message>
    <message>
        <source>bend the plane that was laid last</source>
        <translation>弯曲最后放置的平面</translation>
    </message>
    <message>
        <source>A transfer function</source>
        <translation>传递函数</translation>
    </message>
    <message>
        <source>Drag a point, or a trapezoid&apos;s edge, top or inside</source>
        <translation>拖动节点，或梯形的边、顶或内部</translation>
    </message>
    <message>
        <source>move it; with Shift across or up and down alone; Esc takes it back</source>
        <translation>移动；按住 Shift 仅水平或垂直；Esc 取消</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>add a point, or choose the colour of the point there</source>
        <translation>添加节点，或选择该处节点的颜色</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>右键单击</translation>
    </message>
    <message>
        <source>colour, delete, and add a point or a trapezoid</source>
        <translation>颜色、删除、添加节点或梯形</translation>
    </message>
    <message>
        <source>Wheel, middle drag</source>
        <translation>滚轮、中键拖动</translation>
    </message>
    <message>
        <source>enlarge the values, and move along them</source>
        <translation>放大数值轴并沿其移动</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>move the point; with Shift ten times as far, with Alt its whole trapezoid</source>
        <translation>移动节点；按住 Shift 移动十倍，按住 Alt 移动整个梯形</translation>
    </message>
    <message>
        <source>Page up, Page down, Home, End</source>
        <translation>Page Up、Page Down、Home、End</translation>
    </message>
    <message>
        <source>choose another point</source>
        <translation>选择其他节点</translation>
    </message>
    <message>
        <source>Ins, Del, Return</source>
        <translation>Ins、Del、Return</translation>
    </message>
    <message>
        <source>add a point, delete the point, choose its colour</source>
        <translation>添加节点、删除节点、选择颜色</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>所有视图</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>中键拖动</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>平移图像</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>右键拖动、Ctrl+滚轮</translation>
    </message>
    <message>
        <source>a menu for that place</source>
        <translation>该处的菜单</translation>
    </message>
    <message>
        <source>Shift+move</source>
        <translation>Shift+移动</translation>
    </message>
    <message>
        <source>crosshair follows the mouse</source>
        <translation>十字线跟随鼠标</translation>
    </message>
    <message>
        <source>show this view alone; Esc shows all</source>
        <translation>仅显示此视图；Esc 显示全部</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+滚轮</translation>
    </message>
    <message>
        <source>thickness of the slab, from the slice alone to 100 mm</source>
        <translation>厚层的厚度，从单个层面到 100 mm</translation>
    </message>
    <message>
        <source>The crosshair&apos;s lines, on the slices</source>
        <translation>十字线的线条（层面上）</translation>
    </message>
    <message>
        <source>Drag a ball</source>
        <translation>拖动球</translation>
    </message>
    <message>
        <source>turn the plane of that colour</source>
        <translation>旋转该颜色的平面</translation>
    </message>
    <message>
        <source>hold its line to rows, columns and diagonals</source>
        <translation>使其线条对齐行、列和对角线</translation>
    </message>
    <message>
        <source>turn both planes</source>
        <translation>旋转两个平面</translation>
    </message>
    <message>
        <source>Outlines of the slices, in the 3-D views</source>
        <translation>层面轮廓（三维视图中）</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Home、End</translation>
    </message>
    <message>
        <source>first and last slice</source>
        <translation>第一层与最后一层</translation>
    </message>
    <message>
        <source>move the picture; on the body only while clicks choose no focus (Focus menu)</source>
        <translation>平移图像；在身体上仅当单击不选择焦点时（“焦点”菜单）</translation>
    </message>
    <message>
        <source>What an archive holds</source>
        <translation>归档中的内容</translation>
    </message>
    <message>
        <source>Double-click, Return</source>
        <translation>双击，回车</translation>
    </message>
    <message>
        <source>retrieve the study or series, and open it once it is whole</source>
        <translation>获取检查或序列，完整后打开</translation>
    </message>
    <message>
        <source>Drag onto a view</source>
        <translation>拖到视图上</translation>
    </message>
    <message>
        <source>retrieve what is selected, and open it once it is whole</source>
        <translation>获取所选内容，完整后打开</translation>
    </message>
    <message>
        <source>DICOM tags and label table</source>
        <translation>DICOM 属性与标签表</translation>
    </message>
    <message>
        <source>Click on a label</source>
        <translation>单击标签</translation>
    </message>
    <message>
        <source>crosshair into it</source>
        <translation>十字线移到其中</translation>
    </message>
    <message>
        <source>Ctrl+C, right click</source>
        <translation>Ctrl+C、右击</translation>
    </message>
    <message>
        <source>copy the selected rows, or a value</source>
        <translation>复制所选行或一个值</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>关键图像</translation>
    </message>
    <message>
        <source>Click, Return</source>
        <translation>单击、回车</translation>
    </message>
    <message>
        <source>go back to it</source>
        <translation>返回该图像</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>draw the measure or arrow whose tool is chosen, then type an arrow&apos;s text; Esc ends it</source>
        <translation>绘制所选工具的测量或箭头，然后输入箭头的文字；Esc 结束</translation>
    </message>
    <message>
        <source>Click, as a text&apos;s tool is chosen</source>
        <translation>选择文字工具时单击</translation>
    </message>
    <message>
        <source>place a text, and type it</source>
        <translation>放置文字并输入</translation>
    </message>
    <message>
        <source>copy and delete; change the text of a mark</source>
        <translation>复制和删除；更改标记的文字</translation>
    </message>
    <message>
        <source>The path of the curved reformat, on the slices</source>
        <translation>曲面重建的路径，在层面上</translation>
    </message>
    <message>
        <source>Clicks, as it is being drawn</source>
        <translation>绘制路径时单击</translation>
    </message>
    <message>
        <source>add points; Enter or a double click ends it, Esc drops it</source>
        <translation>添加点；回车或双击结束，Esc 放弃</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>退格键</translation>
    </message>
    <message>
        <source>take the last point away</source>
        <translation>去掉最后一个点</translation>
    </message>
    <message>
        <source>The pictures of the curved reformat</source>
        <translation>曲面重建的图像</translation>
    </message>
    <message>
        <source>crosshair to that place of the path</source>
        <translation>十字线移到路径的该处</translation>
    </message>
    <message>
        <source>Wheel, arrows, Page, Home and End keys</source>
        <translation>滚轮、方向键、翻页键、Home 和 End</translation>
    </message>
    <message>
        <source>move along the path</source>
        <translation>沿路径移动</translation>
    </message>
    <message>
        <source>Drag a point</source>
        <translation>拖动点</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>移动该点</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>slices are shown up to %1 mm from their true places</source>
        <translation>层面显示位置与实际位置相差最多 %1 mm</translation>
    </message>
    <message>
        <source>tilt is made straight: %1 slices are resampled onto %2 planes</source>
        <translation>已校正倾斜：%1 个层面重采样为 %2 个平面</translation>
    </message>
    <message>
        <source>%1 slices are resampled onto %2 even planes</source>
        <translation>%1 个层面重采样为 %2 个等距平面</translation>
    </message>
    <message>
        <source>this plane was not scanned: it is interpolated across a gap</source>
        <translation>此平面未被扫描：由间隙两侧插值得到</translation>
    </message>
    <message>
        <source>%1 of %2 planes are interpolated across gaps</source>
        <translation>%2 个平面中有 %1 个跨间隙插值</translation>
    </message>
    <message>
        <source>places or sizes are assumed, because the file does not give them</source>
        <translation>文件未给出位置或尺寸，采用假定值</translation>
    </message>
    <message>
        <source>some values are outside of what the file&apos;s header allows</source>
        <translation>部分数值超出文件头允许的范围</translation>
    </message>
    <message>
        <source>values are rounded to the precision of the program&apos;s numbers</source>
        <translation>数值按程序的数字精度取整</translation>
    </message>
    <message>
        <source>slices are missing</source>
        <translation>缺少层面</translation>
    </message>
    <message>
        <source>files were left out</source>
        <translation>部分文件被忽略</translation>
    </message>
    <message>
        <source>slices of one place were left out</source>
        <translation>同一位置的层面被忽略</translation>
    </message>
    <message>
        <source>slices of another size or direction are shown as the first one</source>
        <translation>尺寸或方向不同的层面按第一个层面显示</translation>
    </message>
    <message>
        <source>the data differ from those of the session</source>
        <translation>数据与会话中的不同</translation>
    </message>
    <message>
        <source>1 file</source>
        <translation>1 个文件</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 个文件</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by 1 plane</source>
        <translation>部分体数据被 1 个平面裁剪</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by %1 planes</source>
        <translation>部分体数据被 %1 个平面裁剪</translation>
    </message>
    <message>
        <source>1 structure is hidden</source>
        <translation>1 个结构被隐藏</translation>
    </message>
    <message>
        <source>%1 structures are hidden</source>
        <translation>%1 个结构被隐藏</translation>
    </message>
    <message>
        <source>a part of the volume is carved away</source>
        <translation>部分体数据已被雕刻掉</translation>
    </message>
    <message>
        <source>the scanner&apos;s table is left out</source>
        <translation>已去除检查床</translation>
    </message>
    <message>
        <source>parts are moved apart: distances between them do not hold</source>
        <translation>各部分已移开：它们之间的距离无效</translation>
    </message>
    <message>
        <source>a layer is rolled up: distances on it do not hold</source>
        <translation>有一层被卷起：其上的距离无效</translation>
    </message>
    <message>
        <source>values are smoothed between voxels</source>
        <translation>体素间的数值经平滑</translation>
    </message>
    <message>
        <source>values are smoothed over several voxels</source>
        <translation>数值在多个体素上平滑</translation>
    </message>
    <message>
        <source>values between voxels follow a cubic spline, which may overshoot</source>
        <translation>体素间数值采用三次样条，可能产生过冲</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed lightly</source>
        <translation>标签表面轻度平滑</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed strongly</source>
        <translation>标签表面强烈平滑</translation>
    </message>
    <message>
        <source>a draft while something moves, %1 % of the size</source>
        <translation>运动中的草图，尺寸的 %1 %</translation>
    </message>
    <message>
        <source>the sampling error has no bound (quality: %1)</source>
        <translation>采样误差无上限（画质：%1）</translation>
    </message>
    <message>
        <source>the sampling error is at most %1/255</source>
        <translation>采样误差不超过 %L1/255</translation>
    </message>
    <message>
        <source>not verified</source>
        <translation>未验证</translation>
    </message>
    <message>
        <source>verified: %1</source>
        <translation>已验证：%1</translation>
    </message>
    <message>
        <source>not yet what was asked for</source>
        <translation>尚未达到所要求的状态</translation>
    </message>
    <message>
        <source>faithful</source>
        <translation>保真</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>误差有界</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>近似</translation>
    </message>
    <message>
        <source>altered</source>
        <translation>有改动</translation>
    </message>
    <message>
        <source>a slab: only the highest value of %1 mm shows</source>
        <translation>厚层：仅显示 %1 mm 内的最高值</translation>
    </message>
    <message>
        <source>a slab: only the lowest value of %1 mm shows</source>
        <translation>厚层：仅显示 %1 mm 内的最低值</translation>
    </message>
    <message>
        <source>a slab: the mean of %1 mm shows</source>
        <translation>厚层：显示 %1 mm 的均值</translation>
    </message>
    <message>
        <source>values between voxels are interpolated linearly</source>
        <translation>体素间数值为线性插值</translation>
    </message>
</context>
<context>
    <name>FramePacer</name>
    <message>
        <source>draft</source>
        <translation>草图</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>error ≤ %1/255</source>
        <translation>误差 ≤ %L1/255</translation>
    </message>
</context>
<context>
    <name>FunctionTarget</name>
    <message>
        <source>Focus</source>
        <translation>焦点</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>传递函数</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>周围组织</translation>
    </message>
    <message>
        <source>Focus: %1</source>
        <translation>焦点：%1</translation>
    </message>
</context>
<context>
    <name>GlSupport</name>
    <message>
        <source>Qt&apos;s offscreen platform has no OpenGL; unset QT_QPA_PLATFORM.</source>
        <translation>Qt 的 offscreen 平台没有 OpenGL；请取消 QT_QPA_PLATFORM。</translation>
    </message>
    <message>
        <source>No OpenGL context can be made on this display. Install the graphics driver, or Mesa&apos;s software renderer (Debian: libgl1-mesa-dri); on a remote desktop, start Fenestra there.</source>
        <translation>无法在此显示器上创建 OpenGL 上下文。请安装显卡驱动或 Mesa 软件渲染器（Debian：libgl1-mesa-dri）；使用远程桌面时，请在远端启动 Fenestra。</translation>
    </message>
    <message>
        <source>OpenGL cannot draw on this display. On a remote desktop, use one with GLX.</source>
        <translation>OpenGL 无法在此显示器上绘制。使用远程桌面时，请选择支持 GLX 的。</translation>
    </message>
    <message>
        <source>%1 (LIBGL_ALWAYS_SOFTWARE=1 in the environment selects it).</source>
        <translation>%1（环境变量 LIBGL_ALWAYS_SOFTWARE=1 可选择它）。</translation>
    </message>
</context>
<context>
    <name>LabelName</name>
    <message>
        <source>label %1</source>
        <translation>标签 %1</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%L1°</translation>
    </message>
    <message>
        <source>Mean %1 %2</source>
        <translation>均值 %L1 %2</translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>标准差 %L1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%L1 mm²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%L1 cm²</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>箭头</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
</context>
<context>
    <name>MeasureMenu</name>
    <message>
        <source>Copy this measure</source>
        <translation>复制此测量</translation>
    </message>
    <message>
        <source>Copy all as a table (CSV)</source>
        <translation>全部复制为表格 (CSV)</translation>
    </message>
    <message>
        <source>Delete this measure</source>
        <translation>删除此测量</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>删除全部测量</translation>
    </message>
    <message>
        <source>Text of the mark</source>
        <translation>标记的文字</translation>
    </message>
    <message>
        <source>Pictures and sessions hold it: name no patient.</source>
        <translation>图片和会话会包含它：请勿写出患者姓名。</translation>
    </message>
    <message>
        <source>Change the text…</source>
        <translation>更改文字…</translation>
    </message>
</context>
<context>
    <name>MethodRows</name>
    <message>
        <source>Levels</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>rim</source>
        <extracomment>before the number that says how thin the line around a lens is</extracomment>
        <translation>边缘</translation>
    </message>
    <message>
        <source>A</source>
        <comment>axial</comment>
        <translation>轴</translation>
    </message>
    <message>
        <source>S</source>
        <comment>sagittal</comment>
        <translation>矢</translation>
    </message>
    <message>
        <source>C</source>
        <comment>coronal</comment>
        <translation>冠</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>层面</translation>
    </message>
</context>
<context>
    <name>Number</name>
    <message>
        <source>%1 ml</source>
        <translation>%L1 ml</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%L1 l</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>Axial</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>Focus</source>
        <translation>焦点</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>周围组织</translation>
    </message>
    <message>
        <source>Context edges</source>
        <translation>边缘</translation>
    </message>
    <message>
        <source>Cutaway</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>DICOM 属性</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>标签表</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>关键图像</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Curved reformat</source>
        <translation>曲面重建</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
</context>
<context>
    <name>Patient</name>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>出生 %1</translation>
    </message>
</context>
<context>
    <name>PlacementForm</name>
    <message>
        <source>From the side of the body that the focus is nearer to, rather than through the body, where both show about as much</source>
        <translation>显示内容相近时，从焦点较近的身体一侧观察，而非穿过身体</translation>
    </message>
</context>
<context>
    <name>PlaneMenu</name>
    <message>
        <source>Slab of the %1 slice</source>
        <translation>%1层面的厚层</translation>
    </message>
    <message>
        <source>Thickness in mm, half of it to each side; 0 is the slice alone:</source>
        <translation>厚度 (mm)，两侧各一半；0 为单个层面：</translation>
    </message>
    <message>
        <source>Off: the slice alone</source>
        <translation>关：单个层面</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>Other: %1 mm…</source>
        <translation>其他：%1 mm…</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>其他…</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>最大值 (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>最小值 (MinIP)</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>All slices as this one</source>
        <translation>所有层面同此</translation>
    </message>
    <message>
        <source>Slice faces C1</source>
        <translation>层面朝向 C1</translation>
    </message>
    <message>
        <source>Slice faces C2</source>
        <translation>层面朝向 C2</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>厚层</translation>
    </message>
    <message>
        <source>Reset this slice&apos;s plane</source>
        <translation>重置此层面的平面</translation>
    </message>
    <message>
        <source>Reset all planes</source>
        <translation>重置全部平面</translation>
    </message>
</context>
<context>
    <name>PlaneTool</name>
    <message>
        <source>%1°</source>
        <translation>%L1°</translation>
    </message>
</context>
<context>
    <name>Reader</name>
    <message>
        <source>the scanner&apos;s table is left out of 3-D pictures; slices show it</source>
        <translation>三维图像中省略了扫描床；层面仍显示它</translation>
    </message>
    <message>
        <source>the file names no modality; its values (%1 to %2) are taken for Hounsfield units of a CT</source>
        <translation>文件未注明模态；其数值（%1 至 %2）按 CT 的亨氏单位处理</translation>
    </message>
    <message>
        <source>the file stores no orientation; its axes are taken as right, anterior, superior</source>
        <translation>文件未存储方向；其轴按右、前、上处理</translation>
    </message>
    <message>
        <source>the file does not say where the slice lies in the patient</source>
        <translation>文件未说明该层面在患者体内的位置</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; their Slice Location gives their order and a distance of %1 mm, the place is a guess</source>
        <translation>文件未说明其层面在患者体内的位置；Slice Location 给出顺序和 %1 mm 的间距，位置为推测</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; they are shown in their stored order, at a distance that is a guess (%1 mm, %2)</source>
        <translation>文件未说明其层面在患者体内的位置；按存储顺序显示，间距为推测（%1 mm，%2）</translation>
    </message>
    <message>
        <source>no pixel spacing is given; 1 mm is assumed</source>
        <translation>未给出像素间距；假定为 1 mm</translation>
    </message>
    <message>
        <source>the pixel spacing is the detector&apos;s; distances in the patient are smaller</source>
        <translation>像素间距为探测器的间距；患者体内的距离更小</translation>
    </message>
    <message>
        <source>its header has no ElementSpacing; 1 mm is assumed</source>
        <translation>其文件头没有 ElementSpacing；假定为 1 mm</translation>
    </message>
    <message>
        <source>its header has no spacings; 1 mm is assumed</source>
        <translation>其文件头没有体素间距；假定为 1 mm</translation>
    </message>
    <message>
        <source>the file holds %1 volumes (time points or layers); number %2 is shown</source>
        <translation>文件含 %1 个体数据（时间点或层）；显示第 %2 个</translation>
    </message>
    <message>
        <source>all %1 frames lie at one position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>全部 %1 幅图像位于同一位置（时间点或重复采集，并非更厚的体数据%2）；每幅自成一个体数据：显示第 %3 个</translation>
    </message>
    <message>
        <source>%1 frames lie at each position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>每个位置有 %1 幅图像（时间点或重复采集，并非更厚的体数据%2）；各自成为一个体数据：显示第 %3 个</translation>
    </message>
    <message>
        <source>; told apart by %1</source>
        <translation>；按 %1 区分</translation>
    </message>
    <message>
        <source>the slices are tilted by %1 degrees against the direction they are stacked in (%2 mm sideways from slice to slice)</source>
        <translation>层面相对堆叠方向倾斜 %1 度（相邻层面横向偏移 %2 mm）</translation>
    </message>
    <message>
        <source>%1 missing: neighbours lie %2 mm apart, but up to %3 mm between the files named</source>
        <translation>缺少 %1：相邻层面间距 %2 mm，但所列文件之间达 %3 mm</translation>
    </message>
    <message>
        <source>the slices lie between %1 mm and %2 mm apart</source>
        <translation>层面间距在 %1 mm 至 %2 mm 之间</translation>
    </message>
    <message>
        <source>%1 shifted sideways by up to %2 mm from the line that the first and the last one lie on</source>
        <translation>%1 相对首末层面连线横向偏移达 %2 mm</translation>
    </message>
    <message>
        <source>%1 with other directions or pixel spacing than the first; shown with those of the first, pixels lie up to %2 mm from their places</source>
        <translation>%1 的方向或像素间距与第一层不同；按第一层显示，像素偏离其位置达 %2 mm</translation>
    </message>
    <message>
        <source>the volume is sheared, so that every slice lies where it was scanned</source>
        <translation>体数据经剪切变形，使每一层面都在其扫描位置</translation>
    </message>
    <message>
        <source>all slices are shown %1 mm apart, up to %2 mm from where they were scanned</source>
        <translation>所有层面以 %1 mm 间距显示，偏离扫描位置达 %2 mm</translation>
    </message>
    <message>
        <source>%1; %2 of the voxels lie outside of what was scanned and hold the least value, %3</source>
        <translation>%1；%2 的体素位于扫描范围之外，取最小值 %3</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm is interpolated across the gap</source>
        <translation>%1；宽于 %3 mm 的间隙中有 %2 为跨间隙插值</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm are interpolated across the gap</source>
        <translation>%1；宽于 %3 mm 的间隙中有 %2 为跨间隙插值</translation>
    </message>
    <message>
        <source>%1 (evenly spread they would lie up to %2 mm from their places)</source>
        <translation>%1（若均匀分布，将偏离其位置达 %2 mm）</translation>
    </message>
    <message>
        <source>%1, with nothing displaced</source>
        <translation>%1，无位移</translation>
    </message>
    <message>
        <source>%1, displaced by up to %2 mm</source>
        <translation>%1，位移达 %2 mm</translation>
    </message>
    <message>
        <source>%1, sheared as they were scanned</source>
        <translation>%1，按扫描时剪切</translation>
    </message>
    <message>
        <source>linear interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>线性插值将层面置于间距 %2 mm 的 %1 个平面上</translation>
    </message>
    <message>
        <source>cubic interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>三次插值将层面置于间距 %2 mm 的 %1 个平面上</translation>
    </message>
    <message>
        <source>%1 left out: the same images (SOP instances) as in other files</source>
        <translation>省略 %1：与其他文件为相同图像（SOP 实例）</translation>
    </message>
    <message>
        <source>%1 of the folder left out: not DICOM</source>
        <translation>省略文件夹中的 %1：不是 DICOM</translation>
    </message>
    <message>
        <source>%1 left out, unreadable (the first: %2)</source>
        <translation>省略 %1，无法读取（第一个：%2）</translation>
    </message>
    <message>
        <source>%1 listed in the DICOMDIR missing</source>
        <translation>缺少 DICOMDIR 所列的 %1</translation>
    </message>
    <message>
        <source>%1 left out, at positions that other slices have already</source>
        <translation>省略 %1，其位置已有其他层面</translation>
    </message>
    <message>
        <source>%1 of the series put into volumes of their own: %2</source>
        <translation>该序列的 %1 另成体数据：%2</translation>
    </message>
    <message>
        <source>another size or pixel spacing</source>
        <translation>尺寸或像素间距不同</translation>
    </message>
    <message>
        <source>another orientation</source>
        <translation>方向不同</translation>
    </message>
    <message>
        <source>another frame of reference, frame type or stack</source>
        <translation>参考坐标系、图像类型或堆栈不同</translation>
    </message>
    <message>
        <source>%1 slices have a Series UID each; they agree in study and kind and lie evenly, and are taken for one series</source>
        <translation>%1 个层面各有一个序列 UID；它们的检查与类型一致且均匀分布，视为同一序列</translation>
    </message>
    <message>
        <source>%1 left out: %2</source>
        <translation>省略 %1：%2</translation>
    </message>
    <message>
        <source>the focus has no voxels in this volume</source>
        <translation>焦点在此体数据中没有体素</translation>
    </message>
    <message>
        <source>the volume %1 is not what it was when the session was saved</source>
        <translation>体数据 %1 与保存会话时不同</translation>
    </message>
    <message>
        <source>the label map %1 is not what it was when the session was saved</source>
        <translation>标签图 %1 与保存会话时不同</translation>
    </message>
    <message>
        <source>the volume was found at %1, no longer at %2</source>
        <translation>体数据在 %1 找到，已不在 %2</translation>
    </message>
    <message>
        <source>the label map was found at %1, no longer at %2</source>
        <translation>标签图在 %1 找到，已不在 %2</translation>
    </message>
    <message>
        <source>%1 (in %2 of %3 slices)</source>
        <translation>%1（%3 个层面中的 %2 个）</translation>
    </message>
    <message>
        <source>%1 file</source>
        <translation>%1 个文件</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 个文件</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>%1 个层面</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 个层面</translation>
    </message>
    <message>
        <source>%1 plane</source>
        <translation>%1 个平面</translation>
    </message>
    <message>
        <source>%1 planes</source>
        <translation>%1 个平面</translation>
    </message>
</context>
<context>
    <name>Region</name>
    <message>
        <source>Its border is clear: values change by %1 there.</source>
        <translation>边界清晰：该处数值变化 %1。</translation>
    </message>
    <message>
        <source>Its border is fair: values change by %1 there.</source>
        <translation>边界尚可：该处数值变化 %1。</translation>
    </message>
    <message>
        <source>It is doubtful: nearly any other tolerance makes it far larger or smaller. Check its outline on the slices.</source>
        <translation>结果存疑：几乎任何其他容差都会使它大得多或小得多。请在层面上检查其轮廓。</translation>
    </message>
    <message>
        <source>It is doubtful: another region here, far larger or smaller, is nearly as clear. Check its outline on the slices.</source>
        <translation>结果存疑：此处另一个大得多或小得多的区域几乎同样清晰。请在层面上检查其轮廓。</translation>
    </message>
    <message>
        <source>It is doubtful: it spreads from a thin part at the click into a thicker one. Check its outline on the slices.</source>
        <translation>结果存疑：它从点击处的薄部分扩展到了更厚的部分。请在层面上检查其轮廓。</translation>
    </message>
    <message>
        <source>It is doubtful: it is a flat tube, as two vessels side by side are. Check its outline on the slices.</source>
        <translation>结果存疑：它是一条扁平的管状结构，如同两条并行的血管。请在层面上检查其轮廓。</translation>
    </message>
    <message>
        <source>It is doubtful: values change by only %1 along its border. Check its outline on the slices.</source>
        <translation>结果存疑：边界处数值仅变化 %1。请在层面上检查其轮廓。</translation>
    </message>
    <message>
        <source>the left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>the right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>头</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>足</translation>
    </message>
    <message>
        <source>on all sides</source>
        <translation>向四周</translation>
    </message>
    <message>
        <source>towards %1</source>
        <translation>向%1侧</translation>
    </message>
    <message>
        <source>towards %1 and %2</source>
        <translation>向%1侧和%2侧</translation>
    </message>
    <message>
        <source>Values: %1 ± %2.</source>
        <translation>数值：%1 ± %2。</translation>
    </message>
    <message>
        <source>Next leak: at %1 to %2, %3.</source>
        <translation>下一次泄漏：容差 %1 时达 %2，%3。</translation>
    </message>
</context>
<context>
    <name>RegionBall</name>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
</context>
<context>
    <name>RenderProblem</name>
    <message>
        <source>The graphics driver refuses a part of Fenestra (%1). Update the driver, or start Fenestra with LIBGL_ALWAYS_SOFTWARE=1 in the environment.</source>
        <translation>显卡驱动拒绝了 Fenestra 的一部分 (%1)。请更新驱动，或设置环境变量 LIBGL_ALWAYS_SOFTWARE=1 后启动 Fenestra。</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Close other programs, or open a smaller volume.</source>
        <translation>内存不足以绘制此图像。请关闭其他程序，或打开较小的体数据。</translation>
    </message>
</context>
<context>
    <name>Results</name>
    <message>
        <source>Focus</source>
        <translation>焦点</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Segments of the measures</source>
        <translation>测量的分割</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>关键图像</translation>
    </message>
</context>
<context>
    <name>Series</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>every %1</source>
        <translation>每 %1</translation>
    </message>
    <message>
        <source>%1, every %2</source>
        <translation>%1，每 %2</translation>
    </message>
    <message>
        <source>time point %1 of %2</source>
        <translation>时间点 %1 / %2</translation>
    </message>
    <message>
        <source>Series without a name</source>
        <translation>未命名的序列</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>序列 %1</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>检查 %1</translation>
    </message>
</context>
<context>
    <name>ServerEntry</name>
    <message>
        <source>The server&apos;s AE title has 1 to 16 letters and digits; its administrator knows it.</source>
        <translation>服务器的 AE 标题为 1 至 16 个字母和数字；其管理员知道它。</translation>
    </message>
    <message>
        <source>Our AE title has 1 to 16 letters and digits; the server must know it.</source>
        <translation>我方 AE 标题为 1 至 16 个字母和数字；服务器必须知道它。</translation>
    </message>
    <message>
        <source>The host is a name or an address, such as pacs.hospital or 192.168.1.5.</source>
        <translation>主机是名称或地址，如 pacs.hospital 或 192.168.1.5。</translation>
    </message>
    <message>
        <source>C-MOVE needs a port of ours that is entered at the server.</source>
        <translation>C-MOVE 需要在服务器上登记的我方端口。</translation>
    </message>
    <message>
        <source>TLS needs the file of the certificates that may sign the server&apos;s, in PEM.</source>
        <translation>TLS 需要可签署服务器证书的证书文件（PEM）。</translation>
    </message>
    <message>
        <source>Our certificate needs its key, and the key its certificate.</source>
        <translation>我方证书需要其密钥，密钥也需要其证书。</translation>
    </message>
    <message>
        <source>The address is that of DICOMweb&apos;s root, such as https://pacs.hospital/dicom-web.</source>
        <translation>地址为 DICOMweb 的根地址，如 https://pacs.hospital/dicom-web。</translation>
    </message>
    <message>
        <source>A login with a password needs the user&apos;s name.</source>
        <translation>使用密码登录需要用户名。</translation>
    </message>
    <message>
        <source>This desktop has no key ring that runs, so the password or token is not kept.</source>
        <translation>此桌面没有运行中的密钥环，因此不保存密码或令牌。</translation>
    </message>
    <message>
        <source>The key ring was not opened, so the password or token is neither read nor kept.</source>
        <translation>密钥环未打开，因此既不读取也不保存密码或令牌。</translation>
    </message>
    <message>
        <source>The key ring cannot be used: %1</source>
        <translation>无法使用密钥环：%1</translation>
    </message>
    <message>
        <source>Waiting for the key ring of the desktop…</source>
        <translation>正在等待桌面的密钥环…</translation>
    </message>
    <message>
        <source>Go on without</source>
        <translation>不使用并继续</translation>
    </message>
    <message>
        <source>The key ring was not waited for.</source>
        <translation>未等待密钥环。</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>Light theme</source>
        <translation>浅色主题</translation>
    </message>
    <message>
        <source>Light colours around the pictures, for bright rooms</source>
        <translation>图像周围使用浅色，适合明亮的房间</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>相机动画</translation>
    </message>
    <message>
        <source>Cameras fly to where they are placed instead of jumping there</source>
        <translation>相机平滑移动到位，而不是跳转</translation>
    </message>
    <message>
        <source>While something moves</source>
        <translation>运动时</translation>
    </message>
    <message>
        <source>Pictures a second to aim at: more of them are smaller on a slow machine. At rest they always have full quality</source>
        <translation>目标每秒图像数：在较慢的机器上，越多则图像越小。静止时始终为完整画质</translation>
    </message>
    <message>
        <source>pictures/s</source>
        <translation>幅/秒</translation>
    </message>
    <message>
        <source>Background of new data</source>
        <translation>新数据的背景</translation>
    </message>
    <message>
        <source>Colour behind the volume when data are opened without a session</source>
        <translation>不带会话打开数据时体数据后面的颜色</translation>
    </message>
    <message>
        <source>Unit of new openings</source>
        <translation>新开口的单位</translation>
    </message>
    <message>
        <source>What the widths of the opening are in when data are opened without a session</source>
        <translation>不带会话打开数据时开口宽度的单位</translation>
    </message>
    <message>
        <source>Hide the patient</source>
        <translation>隐藏患者信息</translation>
    </message>
    <message>
        <source>No patient and no study in corner texts, and no folder that may be named after them in the recent list and in what file dialogs remember</source>
        <translation>四角文字不显示患者和检查；最近列表和文件对话框不记录可能以其命名的文件夹</translation>
    </message>
    <message>
        <source>Remember recent data</source>
        <translation>记住最近的数据</translation>
    </message>
    <message>
        <source>List the folders and files opened last in the File menu</source>
        <translation>在“文件”菜单中列出最近打开的文件夹和文件</translation>
    </message>
    <message>
        <source>Keep a copy of unsaved work</source>
        <translation>保留未保存工作的副本</translation>
    </message>
    <message>
        <source>Every minute, to be offered after a crash</source>
        <translation>每分钟一次，崩溃后提供恢复</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>How the view is opened to the focus</source>
        <translation>视图如何向焦点打开</translation>
    </message>
    <message>
        <source>Adaptive cutaway</source>
        <translation>自适应剖切</translation>
    </message>
    <message>
        <source>An opening around the focus that rises to the surface over a width that you choose: the method of this program</source>
        <translation>围绕焦点、在所选宽度内上升到表面的开口：本程序的方法</translation>
    </message>
    <message>
        <source>Deformable cutting plane</source>
        <translation>可变形切割平面</translation>
    </message>
    <message>
        <source>Nothing opens by itself: a plane that you lay through a stroke and bend by dragging removes one side of it (Konrad-Verse, Preim and Littmann 2004)</source>
        <translation>不自动打开：您用笔画放置并拖动弯曲的平面移除其一侧 (Konrad-Verse, Preim, Littmann 2004)</translation>
    </message>
    <message>
        <source>ClearView</source>
        <translation>ClearView</translation>
    </message>
    <message>
        <source>A lens over the focus through which it shows, while what hides it fades towards the lens&apos;s middle and stays where it bends (Krüger, Schneider and Westermann 2006)</source>
        <translation>焦点上方的透镜，透过它可见焦点；遮挡物向透镜中心淡化，弯曲处保留 (Krüger, Schneider, Westermann 2006)</translation>
    </message>
    <message>
        <source>Lens keeps</source>
        <translation>透镜保留</translation>
    </message>
    <message>
        <source>What stays within ClearView&apos;s lens of what hides the focus, beside its bends</source>
        <translation>ClearView 透镜内除弯曲处外保留多少遮挡焦点的组织</translation>
    </message>
    <message>
        <source>Lens over</source>
        <translation>透镜位置</translation>
    </message>
    <message>
        <source>What ClearView&apos;s lens lies over, as you see it</source>
        <translation>ClearView 透镜所覆盖的位置</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>透镜</translation>
    </message>
    <message>
        <source>Radius of ClearView&apos;s lens, as a share of the volume&apos;s longest side; its authors use 18.2</source>
        <translation>ClearView 透镜半径，占体数据最长边的比例；原作者取 18.2</translation>
    </message>
    <message>
        <source>Bends kept</source>
        <translation>保留弯曲</translation>
    </message>
    <message>
        <source>How much of the bends of what hides the focus stays within ClearView&apos;s lens; 0 keeps none</source>
        <translation>ClearView 透镜内保留多少遮挡物的弯曲；0 为不保留</translation>
    </message>
    <message>
        <source>Rim of the lens</source>
        <translation>透镜边缘</translation>
    </message>
    <message>
        <source>How thin the dark line around ClearView&apos;s lens is: more is thinner</source>
        <translation>ClearView 透镜周围暗线的细度：越大越细</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>焦点</translation>
    </message>
    <message>
        <source>The middle of the focus</source>
        <translation>焦点的中心</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>十字线</translation>
    </message>
    <message>
        <source>The crosshair: the lens follows what you point at</source>
        <translation>十字线：透镜跟随所指位置</translation>
    </message>
    <message>
        <source>To the rim</source>
        <translation>向边缘</translation>
    </message>
    <message>
        <source>The nearer to the lens&apos;s rim, the more of what hides the focus</source>
        <translation>越靠近透镜边缘，保留的遮挡物越多</translation>
    </message>
    <message>
        <source>Evenly</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Nothing but the bends of what hides the focus</source>
        <translation>仅保留遮挡物的弯曲</translation>
    </message>
    <message>
        <source>With depth</source>
        <translation>随深度</translation>
    </message>
    <message>
        <source>The more lies in front of the focus, the more of it</source>
        <translation>焦点前方组织越多，保留越多</translation>
    </message>
    <message>
        <source>Cone cutaway</source>
        <translation>锥形剖切</translation>
    </message>
    <message>
        <source>A funnel around everything in focus, which widens towards you at one angle: the deeper the focus lies, the wider the opening (Burns and Finkelstein 2008)</source>
        <translation>围绕焦点、以固定角度向您扩张的漏斗：焦点越深开口越宽 (Burns, Finkelstein 2008)</translation>
    </message>
    <message>
        <source>Cone&apos;s angle</source>
        <translation>锥角</translation>
    </message>
    <message>
        <source>Angle between the axis and the wall of the cone cutaway&apos;s cones: more opens wider</source>
        <translation>锥形剖切的轴与锥壁夹角：越大开口越宽</translation>
    </message>
    <message>
        <source>Context-preserving</source>
        <translation>保留上下文</translation>
    </message>
    <message>
        <source>Nothing is cut away: what is flat, brightly lit and near to you fades, while edges stay, so that the inside shows; what is in focus stays as it is (Bruckner, Grimm, Kanitsar and Gröller 2006)</source>
        <translation>不切除任何组织：平坦、明亮且靠近您的部分淡化，边缘保留，从而显示内部；焦点保持原样 (Bruckner, Grimm, Kanitsar, Gröller 2006)</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>作用范围</translation>
    </message>
    <message>
        <source>How deep the context-preserving method looks into the volume; 0 fades nothing (κt)</source>
        <translation>保留上下文方法观察体数据的深度；0 为不淡化 (κt)</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>锐度</translation>
    </message>
    <message>
        <source>How sudden the context-preserving method changes from faded to shown along the line of sight: more looks like a cut (κs)</source>
        <translation>沿视线从淡化到显示的转变有多突然：越大越像切面 (κs)</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>爆炸视图</translation>
    </message>
    <message>
        <source>What is around the focus is cut into parts, which move apart and out of your line of sight to it; what is in focus stays in its place (Bruckner and Gröller 2006)</source>
        <translation>焦点周围被切成若干部分并移离视线；焦点留在原位 (Bruckner, Gröller 2006)</translation>
    </message>
    <message>
        <source>Explosion</source>
        <translation>爆炸程度</translation>
    </message>
    <message>
        <source>How far the parts of an exploded view are moved apart (its degree of explosion): at 0 all are in their places</source>
        <translation>各部分移开的距离（爆炸程度）：0 时均在原位</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>分块</translation>
    </message>
    <message>
        <source>How many planes through the middle of the focus, or of the volume without a focus, cut it into the parts of an exploded view</source>
        <translation>通过焦点中心（无焦点时为体数据中心）将其切成若干部分的平面数</translation>
    </message>
    <message>
        <source>Cut along</source>
        <translation>切割方向</translation>
    </message>
    <message>
        <source>Whether the planes of an exploded view lie along the patient&apos;s axes or the view&apos;s</source>
        <translation>爆炸视图的平面沿患者轴还是视图轴</translation>
    </message>
    <message>
        <source>Two halves</source>
        <translation>两半</translation>
    </message>
    <message>
        <source>One plane cuts the volume into left and right</source>
        <translation>一个平面将体数据分为左右</translation>
    </message>
    <message>
        <source>Four quarters</source>
        <translation>四份</translation>
    </message>
    <message>
        <source>Two planes: left and right, above and below</source>
        <translation>两个平面：左右、上下</translation>
    </message>
    <message>
        <source>Eight parts</source>
        <translation>八份</translation>
    </message>
    <message>
        <source>Three planes: left and right, above and below, front and back</source>
        <translation>三个平面：左右、上下、前后</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>患者</translation>
    </message>
    <message>
        <source>Planes along the patient&apos;s axes: left and right are the patient&apos;s</source>
        <translation>沿患者轴的平面：左右为患者的左右</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Planes along the picture&apos;s axes, which turn with the camera</source>
        <translation>沿图像轴的平面，随相机转动</translation>
    </message>
    <message>
        <source>Focal region</source>
        <translation>焦点区域</translation>
    </message>
    <message>
        <source>A region around the focus shows as it is; around it only the edges of what is there stay, the fainter the farther away; what is in focus stays as it is (Zhou, Hinz and Tönnies 2002)</source>
        <translation>焦点周围的区域原样显示；其外仅保留边缘，越远越淡；焦点保持原样 (Zhou, Hinz, Tönnies 2002)</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Shape of the focal region, around the focus, or around the middle of the volume without a focus</source>
        <translation>焦点区域的形状，围绕焦点，或无焦点时围绕体数据中心</translation>
    </message>
    <message>
        <source>Size of region</source>
        <translation>区域大小</translation>
    </message>
    <message>
        <source>Radius of the focal region&apos;s sphere, half the side of its box, or its distance from the focus</source>
        <translation>焦点区域的球半径、立方体半边长或到焦点的距离</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>衰减</translation>
    </message>
    <message>
        <source>How far outside of the focal region edges are half as strong as at its border: more shows more of what is around it</source>
        <translation>在焦点区域外多远处边缘强度减半：越大显示的周围越多</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>A ball around the middle of the focus</source>
        <translation>围绕焦点中心的球</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>A cube along the patient&apos;s axes, around the middle of the focus</source>
        <translation>沿患者轴、围绕焦点中心的立方体</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Everything that lies near the focus, whatever its shape</source>
        <translation>焦点附近的一切，不论其形状</translation>
    </message>
    <message>
        <source>Importance-driven</source>
        <translation>重要性驱动</translation>
    </message>
    <message>
        <source>What hides the focus gives way to it because the focus is more important: it is removed, or stays faint (Viola, Kanitsar and Gröller 2004)</source>
        <translation>焦点更重要，遮挡物为其让路：被移除或淡化 (Viola, Kanitsar, Gröller 2004)</translation>
    </message>
    <message>
        <source>What hides the focus</source>
        <translation>遮挡焦点者</translation>
    </message>
    <message>
        <source>What the importance-driven method does with what hides the focus</source>
        <translation>重要性驱动方法如何处理遮挡焦点的组织</translation>
    </message>
    <message>
        <source>Widening</source>
        <translation>扩张角</translation>
    </message>
    <message>
        <source>Angle at which the importance-driven opening widens from the focus&apos;s outline towards the eye</source>
        <translation>开口从焦点轮廓向观察者扩张的角度</translation>
    </message>
    <message>
        <source>Opacity left</source>
        <translation>剩余不透明度</translation>
    </message>
    <message>
        <source>Factor of the opacity of what hides the focus, where the importance-driven method keeps it faint; 0 removes it</source>
        <translation>遮挡焦点者保持淡化时的不透明度系数；0 为移除</translation>
    </message>
    <message>
        <source>Faint how</source>
        <translation>淡化方式</translation>
    </message>
    <message>
        <source>How what hides the focus is made faint</source>
        <translation>如何淡化遮挡焦点的组织</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>What hides the focus is removed, in a cone that widens from the focus&apos;s outline towards you (maximum importance projection)</source>
        <translation>移除遮挡焦点的组织，范围为从焦点轮廓向观察者扩张的锥体（最大重要性投影）</translation>
    </message>
    <message>
        <source>Faint</source>
        <translation>淡化</translation>
    </message>
    <message>
        <source>What hides the focus stays, but faint (average importance compositing)</source>
        <translation>遮挡焦点的组织保留但淡化（平均重要性合成）</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>半透明</translation>
    </message>
    <message>
        <source>Less opaque, in its own colours</source>
        <translation>降低不透明度，保持原色</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>灰色</translation>
    </message>
    <message>
        <source>Less opaque, and grey, so that the colours are the focus&apos;s alone</source>
        <translation>降低不透明度并变灰，仅焦点有颜色</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>点状</translation>
    </message>
    <message>
        <source>As it is on a few pixels in an even pattern, and left out on the others</source>
        <translation>按均匀图案在少数像素上原样显示，其余省略</translation>
    </message>
    <message>
        <source>Maximum intensity (MIP)</source>
        <translation>最大密度 (MIP)</translation>
    </message>
    <message>
        <source>The body shows by the greatest value on each line of sight, as in a maximum intensity projection, and the focus stands in it; what lies before the opening does not count (Wallis, Miller, Lerner and Kleerup 1989)</source>
        <translation>身体以每条视线上的最大值显示（最大密度投影），焦点置于其中；开口前方不计 (Wallis, Miller, Lerner, Kleerup 1989)</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>How thick a layer the maximum intensity projection shows of the greatest value: more is more opaque</source>
        <translation>最大密度投影以多厚的一层显示最大值：越厚越不透明</translation>
    </message>
    <message>
        <source>Peeling</source>
        <translation>剥离</translation>
    </message>
    <message>
        <source>A layer in front of the focus is cut in two, and its halves are rolled aside like a peel; what is in focus stays in its place (McGuffin et al. 2003; Correa et al. 2006)</source>
        <translation>焦点前方的一层被切成两半，如剥皮般向两侧卷起；焦点留在原位 (McGuffin et al. 2003; Correa et al. 2006)</translation>
    </message>
    <message>
        <source>Peeled</source>
        <translation>剥离程度</translation>
    </message>
    <message>
        <source>How far the layer in front of the focus is peeled away: at 0 it lies in its place, at 1 none of it lies in front of the focus</source>
        <translation>焦点前方的层剥离多少：0 在原位，1 时完全不在焦点前方</translation>
    </message>
    <message>
        <source>Peel off</source>
        <translation>剥离侧</translation>
    </message>
    <message>
        <source>Which side of the patient the layer is peeled off</source>
        <translation>从患者哪一侧剥离</translation>
    </message>
    <message>
        <source>Cut turned by</source>
        <translation>切口旋转</translation>
    </message>
    <message>
        <source>Turns the cut through the layer: at 0 it runs from head to foot, or from front to back where the layer is peeled off above or below</source>
        <translation>旋转层上的切口：0 为从头到足，若从上或下剥离则为从前到后</translation>
    </message>
    <message>
        <source>Layer down to</source>
        <translation>层深</translation>
    </message>
    <message>
        <source>How deep the layer reaches: at 0 it ends just in front of the focus, at 1 just behind it</source>
        <translation>层的深度：0 止于焦点前方，1 止于焦点后方</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>卷曲</translation>
    </message>
    <message>
        <source>Radius of the hollow in the roll: less rolls the layer up more tightly</source>
        <translation>卷筒中空的半径：越小卷得越紧</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>How far the opened window reaches beyond the focus on all its sides</source>
        <translation>打开的窗口在各边超出焦点的距离</translation>
    </message>
    <message>
        <source>The front</source>
        <translation>前面</translation>
    </message>
    <message>
        <source>The patient&apos;s anterior side</source>
        <translation>患者的前侧</translation>
    </message>
    <message>
        <source>The back</source>
        <translation>后面</translation>
    </message>
    <message>
        <source>The patient&apos;s posterior side</source>
        <translation>患者的后侧</translation>
    </message>
    <message>
        <source>The left</source>
        <translation>左面</translation>
    </message>
    <message>
        <source>The patient&apos;s left side</source>
        <translation>患者的左侧</translation>
    </message>
    <message>
        <source>The right</source>
        <translation>右面</translation>
    </message>
    <message>
        <source>The patient&apos;s right side</source>
        <translation>患者的右侧</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>上面</translation>
    </message>
    <message>
        <source>The patient&apos;s superior side</source>
        <translation>患者的上侧</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>下面</translation>
    </message>
    <message>
        <source>The patient&apos;s inferior side</source>
        <translation>患者的下侧</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Nothing opens by itself: you carve the volume with a ball, a box or a saw until the focus shows (Wang and Kaufman 1995)</source>
        <translation>不自动打开：您用球、长方体或锯雕刻体数据，直到焦点可见 (Wang, Kaufman 1995)</translation>
    </message>
    <message>
        <source>Ghosted selection</source>
        <translation>虚影选择</translation>
    </message>
    <message>
        <source>Nothing is cut away: in front of the focus, and in the opening around it, what is flat gives way and edges stay, like a ghost of it; what is in focus stays as it is (Bruckner and Gröller 2005)</source>
        <translation>不切除任何组织：焦点前方及其开口内平坦处让开、边缘保留，如虚影；焦点保持原样 (Bruckner, Gröller 2005)</translation>
    </message>
    <message>
        <source>Ghosting</source>
        <translation>虚化</translation>
    </message>
    <message>
        <source>How much of what is flat in front of the selection gives way; 0 fades nothing</source>
        <translation>选择前方的平坦部分让开多少；0 为不淡化</translation>
    </message>
    <message>
        <source>Edges from</source>
        <translation>边缘阈值</translation>
    </message>
    <message>
        <source>Gradient of which half stays in front of the selection, as a share of the steepest that the volume can have: less keeps fainter edges</source>
        <translation>在选择前方保留一半的梯度，占体数据可能最大梯度的比例：越小保留越弱的边缘</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>How much edges that face you give way, too, so that outlines stay in front of the selection</source>
        <translation>面向您的边缘也让开多少，使选择前方仅留轮廓</translation>
    </message>
    <message>
        <source>Walls of slices</source>
        <translation>层面墙</translation>
    </message>
    <message>
        <source>The adaptive cutaway with the slices at the crosshair as walls: behind the volume, or inside the opening (Tory and Swindells 2003)</source>
        <translation>自适应剖切，以十字线处的层面为墙：位于体数据后方或开口内 (Tory, Swindells 2003)</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>Where the walls of slices stand</source>
        <translation>层面墙的位置</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Whether the axial slice at the crosshair is a wall</source>
        <translation>十字线处的轴位层面是否为墙</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
    </message>
    <message>
        <source>Whether the sagittal slice at the crosshair is a wall</source>
        <translation>十字线处的矢状位层面是否为墙</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
    <message>
        <source>Whether the coronal slice at the crosshair is a wall</source>
        <translation>十字线处的冠状位层面是否为墙</translation>
    </message>
    <message>
        <source>Whether the labels&apos; outlines are drawn on the walls</source>
        <translation>是否在墙上绘制标签轮廓</translation>
    </message>
    <message>
        <source>Around the volume</source>
        <translation>体数据周围</translation>
    </message>
    <message>
        <source>Behind the volume, like the walls of a room</source>
        <translation>在体数据后方，如房间的墙</translation>
    </message>
    <message>
        <source>Inside the opening</source>
        <translation>开口内</translation>
    </message>
    <message>
        <source>Where the slices lie, in the space that the opening removed; before the focus there is none</source>
        <translation>在开口移除的空间内、层面所在处；焦点前方没有</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>millimetres at the focus</source>
        <translation>焦点处的毫米</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>A ball, where the mouse goes</source>
        <translation>沿鼠标轨迹的球</translation>
    </message>
    <message>
        <source>A box that faces you, where the mouse goes</source>
        <translation>沿鼠标轨迹、面向您的长方体</translation>
    </message>
    <message>
        <source>Saw</source>
        <translation>锯</translation>
    </message>
    <message>
        <source>A blade along the stroke, away from you; a stroke that comes back to its start takes out what it encloses</source>
        <translation>沿笔画向前的锯片；笔画回到起点时切除其包围的部分</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>A plane through the stroke that removes what lies to the right of it, and that you bend by dragging</source>
        <translation>经过笔画的平面，移除其右侧部分，可拖动弯曲</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Brings back what the opening removed</source>
        <translation>恢复开口移除的组织</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Opens further, away from the eye</source>
        <translation>沿视线方向进一步打开</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>减弱</translation>
    </message>
    <message>
        <source>Shows less of the context&apos;s edges over the focus</source>
        <translation>减少焦点上方的周围组织边缘</translation>
    </message>
    <message>
        <source>Strengthen</source>
        <translation>增强</translation>
    </message>
    <message>
        <source>Shows more of the context&apos;s edges over the focus</source>
        <translation>增加焦点上方的周围组织边缘</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>周围组织</translation>
    </message>
    <message>
        <source>Cut away where it hides the focus</source>
        <translation>遮挡焦点处被切除</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Left out of 3-D pictures; slices show its voxels</source>
        <translation>三维图像中不显示；层面仍显示其体素</translation>
    </message>
    <message>
        <source>Protected</source>
        <translation>保护</translation>
    </message>
    <message>
        <source>Never cut away, even where it hides the focus</source>
        <translation>即使遮挡焦点也绝不切除</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>What is connected to the click by values near its own</source>
        <translation>与单击处数值相近且相连的部分</translation>
    </message>
    <message>
        <source>Tissues</source>
        <translation>组织</translation>
    </message>
    <message>
        <source>What belongs to the clicked tissue more than to any other of the volume</source>
        <translation>比起体数据中其他组织更属于所单击组织的部分</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Straight lines between voxels: coarse scans show terraces</source>
        <translation>体素间为直线：粗糙扫描会出现阶梯</translation>
    </message>
    <message>
        <source>Curved</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Smooth curves through every voxel, its noise as well: takes more memory and time</source>
        <translation>经过每个体素（含噪声）的平滑曲线：占用更多内存和时间</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Smooth curves near the voxels: fewer terraces and less noise, but softer detail</source>
        <translation>接近体素的平滑曲线：阶梯和噪声减少，细节变柔</translation>
    </message>
    <message>
        <source>Smoothed more</source>
        <translation>更平滑</translation>
    </message>
    <message>
        <source>Smooth curves near means over five voxels: no terraces in coarse scans, but fine detail is lost</source>
        <translation>接近五体素均值的平滑曲线：粗糙扫描无阶梯，但丢失细节</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Smoothed where voxels are coarse and not too many, else straight</source>
        <translation>体素粗大且数量不多时平滑，否则直线</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>单色</translation>
    </message>
    <message>
        <source>The background&apos;s colour everywhere</source>
        <translation>全部为背景颜色</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>From the background&apos;s colour at the bottom to another at the top</source>
        <translation>从底部的背景颜色渐变到顶部的另一颜色</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>As the labels have it, with the steps of their voxels</source>
        <translation>与标签一致，带体素阶梯</translation>
    </message>
    <message>
        <source>Lightly smoothed</source>
        <translation>轻度平滑</translation>
    </message>
    <message>
        <source>Without the steps of single voxels</source>
        <translation>去除单个体素的阶梯</translation>
    </message>
    <message>
        <source>Strongly smoothed</source>
        <translation>强烈平滑</translation>
    </message>
    <message>
        <source>Without terraces of several voxels</source>
        <translation>去除多个体素的阶梯</translation>
    </message>
    <message>
        <source>One ray a pixel</source>
        <translation>每像素一条光线</translation>
    </message>
    <message>
        <source>Edges show the steps of the pixels</source>
        <translation>边缘显示像素阶梯</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Several rays for each pixel that an edge runs through</source>
        <translation>边缘经过的每个像素使用多条光线</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>正交</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>草图</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>high</source>
        <translation>高</translation>
    </message>
    <message>
        <source>Open the context around the focus</source>
        <translation>打开焦点周围的组织</translation>
    </message>
    <message>
        <source>Whether the context is cut away around the focus</source>
        <translation>是否切除焦点周围的组织</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>开口</translation>
    </message>
    <message>
        <source>How far the opening reaches beyond the focus (w_open)</source>
        <translation>开口超出焦点的距离 (w_open)</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>边框</translation>
    </message>
    <message>
        <source>Width of the line around the opening (w_border)</source>
        <translation>开口周围线条的宽度 (w_border)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Unit of both widths: pixels of the screen, or mm at the depth of the focus, which keep the opening still while zooming</source>
        <translation>两个宽度的单位：屏幕像素，或焦点深度处的 mm（缩放时开口不变）</translation>
    </message>
    <message>
        <source>Border colour</source>
        <translation>边框颜色</translation>
    </message>
    <message>
        <source>Colour of the line around the opening</source>
        <translation>开口周围线条的颜色</translation>
    </message>
    <message>
        <source>Axis offset</source>
        <translation>轴偏角</translation>
    </message>
    <message>
        <source>Angle between the opening&apos;s axis and the line of sight, so that its depth shows</source>
        <translation>开口轴与视线的夹角，使其深度可见</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>To which side of the picture the opening&apos;s axis leans: 0 is the right, 90 the top</source>
        <translation>开口轴向图像哪一侧倾斜：0 为右，90 为上</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>How strongly the edges of the removed context are drawn over the focus; 0 draws none</source>
        <translation>被移除组织的边缘在焦点上的绘制强度；0 为不绘制</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>曲率</translation>
    </message>
    <message>
        <source>How much bends of the context&apos;s surface count as edges: eyes, nose, ears</source>
        <translation>周围组织表面的弯曲（眼、鼻、耳）作为边缘的权重</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>轮廓线</translation>
    </message>
    <message>
        <source>How much the context&apos;s outlines, where its surface is seen edge-on, count as edges</source>
        <translation>周围组织轮廓（表面与视线相切处）作为边缘的权重</translation>
    </message>
    <message>
        <source>Illumination</source>
        <translation>光照</translation>
    </message>
    <message>
        <source>How much the light on the context&apos;s surface shades its edges; 0 draws them flat</source>
        <translation>周围组织表面光照对边缘明暗的影响；0 为平涂</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>固有色</translation>
    </message>
    <message>
        <source>How much the edges take the context&apos;s own colour</source>
        <translation>边缘采用周围组织自身颜色的程度</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>饱和度</translation>
    </message>
    <message>
        <source>How saturated the context&apos;s own colour is in its edges</source>
        <translation>边缘中周围组织颜色的饱和度</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
    <message>
        <source>How much of the focus the edges may cover at most: the strongest stay; 1 keeps all</source>
        <translation>边缘最多可覆盖焦点的比例：保留最强者；1 全部保留</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Colour of the context&apos;s edges</source>
        <translation>周围组织边缘的颜色</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>明暗</translation>
    </message>
    <message>
        <source>Whether surfaces are lit by the gradient of the values</source>
        <translation>是否按数值梯度为表面打光</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>环境光</translation>
    </message>
    <message>
        <source>Light from all sides</source>
        <translation>来自各个方向的光</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>漫反射</translation>
    </message>
    <message>
        <source>Light that a matt surface scatters</source>
        <translation>无光泽表面散射的光</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>镜面反射</translation>
    </message>
    <message>
        <source>Strength of the highlights</source>
        <translation>高光强度</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>光泽度</translation>
    </message>
    <message>
        <source>Exponent of the highlights: a larger one makes them smaller and sharper</source>
        <translation>高光指数：越大高光越小越锐</translation>
    </message>
    <message>
        <source>Light azimuth</source>
        <translation>光源方位角</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is behind the viewer, 90 the right of the picture</source>
        <translation>光的来向：0 为观察者后方，90 为图像右侧</translation>
    </message>
    <message>
        <source>Light elevation</source>
        <translation>光源高度角</translation>
    </message>
    <message>
        <source>How high the light stands: 90 is the top of the picture, -90 the bottom</source>
        <translation>光源高度：90 为图像顶部，-90 为底部</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>环境遮蔽</translation>
    </message>
    <message>
        <source>How dark hollows are, which what is around them hides from the light from all sides; 0 leaves them as bright as the rest and costs nothing</source>
        <translation>被周围遮住环境光的凹陷有多暗；0 与其余部分同亮且无开销</translation>
    </message>
    <message>
        <source>Soft shadow</source>
        <translation>柔和阴影</translation>
    </message>
    <message>
        <source>How dark the shadows are that the volume, as it is cut open, casts on itself; 0 casts none and costs nothing</source>
        <translation>剖开的体数据投射在自身上的阴影有多暗；0 为无阴影且无开销</translation>
    </message>
    <message>
        <source>Colour of a focus of values; labels have colours of their own</source>
        <translation>按数值设定的焦点的颜色；标签有自己的颜色</translation>
    </message>
    <message>
        <source>Extinction</source>
        <translation>消光</translation>
    </message>
    <message>
        <source>Extinction coefficient of the focus</source>
        <translation>焦点的消光系数</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>Smallest island</source>
        <translation>最小孤岛</translation>
    </message>
    <message>
        <source>Volume below which an island of a focus of values is left out</source>
        <translation>小于此体积的孤岛不计入按数值设定的焦点</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Moves the whole transfer function along the values</source>
        <translation>沿数值轴平移整个传递函数</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Colour behind the volume; of a gradient, at the bottom</source>
        <translation>体数据后面的颜色；渐变时为底部颜色</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>背景类型</translation>
    </message>
    <message>
        <source>Whether one colour is behind the volume, or a gradient of two</source>
        <translation>体数据后面是单色还是双色渐变</translation>
    </message>
    <message>
        <source>Top of the gradient</source>
        <translation>渐变顶部</translation>
    </message>
    <message>
        <source>Colour of a gradient behind the volume at the top</source>
        <translation>体数据后面渐变的顶部颜色</translation>
    </message>
    <message>
        <source>Hide the table</source>
        <translation>隐藏检查床</translation>
    </message>
    <message>
        <source>Whether 3-D pictures of a CT leave out the scanner&apos;s table, head rest and cushions</source>
        <translation>CT 的三维图像是否去除检查床、头托和垫子</translation>
    </message>
    <message>
        <source>Between voxels</source>
        <translation>体素之间</translation>
    </message>
    <message>
        <source>How 3-D pictures fill in the values between the voxels</source>
        <translation>三维图像如何填补体素之间的数值</translation>
    </message>
    <message>
        <source>Label surfaces</source>
        <translation>标签表面</translation>
    </message>
    <message>
        <source>How far 3-D pictures smooth the surface of labels in focus: it stays within the voxels that it passes through, and keeps its volume</source>
        <translation>三维图像对焦点标签表面的平滑程度：保持在其穿过的体素内，体积不变</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边缘</translation>
    </message>
    <message>
        <source>Whether 3-D pictures at rest smooth outlines and the rims of what is cut</source>
        <translation>静止时三维图像是否平滑轮廓和切缘</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>What the stroke does</source>
        <translation>笔画的作用</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>柔和度</translation>
    </message>
    <message>
        <source>Share of the radius over which the effect fades out</source>
        <translation>效果渐隐所占的半径比例</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>How far along the ray Restore and Open move its start at most</source>
        <translation>“恢复”和“打开”沿光线移动起点的最大距离</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>How much of the context&apos;s edges Fade takes or Strengthen adds</source>
        <translation>“减弱”去除或“增强”添加周围组织边缘的程度</translation>
    </message>
    <message>
        <source>To the surface</source>
        <translation>至表面</translation>
    </message>
    <message>
        <source>Whether Restore reaches to the context&apos;s first surface, however deep that lies</source>
        <translation>“恢复”是否直达周围组织的第一个表面，不论深度</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>可遮挡焦点</translation>
    </message>
    <message>
        <source>Whether restored context may hide the focus</source>
        <translation>恢复的周围组织是否可遮挡焦点</translation>
    </message>
    <message>
        <source>Whether the stroke is kept without effect</source>
        <translation>笔画是否保留但不生效</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>View in which it shows: 0 for C1, 1 for C2, -1 for both</source>
        <translation>显示的视图：0 为 C1，1 为 C2，-1 为两者</translation>
    </message>
    <message>
        <source>Edges and border</source>
        <translation>边缘与边框</translation>
    </message>
    <message>
        <source>Cut alone</source>
        <translation>仅剖切</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>周围组织边缘</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>A little gloss</source>
        <translation>略有光泽</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>哑光</translation>
    </message>
    <message>
        <source>Without highlights, as plaster</source>
        <translation>无高光，如石膏</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>骨</translation>
    </message>
    <message>
        <source>Soft shades and a wide sheen</source>
        <translation>柔和明暗与宽阔光泽</translation>
    </message>
    <message>
        <source>Wet</source>
        <translation>湿润</translation>
    </message>
    <message>
        <source>Small and strong highlights, as moist tissue in an operation</source>
        <translation>小而强的高光，如手术中的湿润组织</translation>
    </message>
    <message>
        <source>Technical</source>
        <translation>技术</translation>
    </message>
    <message>
        <source>Even light that keeps colours to be told apart</source>
        <translation>均匀光照，便于区分颜色</translation>
    </message>
    <message>
        <source>the point lies outside of the volume</source>
        <translation>该点位于体数据之外</translation>
    </message>
    <message>
        <source>the point lies in air, where there is no structure</source>
        <translation>该点位于空气中，没有结构</translation>
    </message>
    <message>
        <source>no region can be grown from the point</source>
        <translation>无法从该点生长区域</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>头部</translation>
    </message>
    <message>
        <source>Torso</source>
        <translation>躯干</translation>
    </message>
    <message>
        <source>CT angio</source>
        <translation>CT 血管</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>CT 骨</translation>
    </message>
    <message>
        <source>CT lung</source>
        <translation>CT 肺</translation>
    </message>
    <message>
        <source>CT plain</source>
        <translation>CT 普通</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>CT 皮肤</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>CT 软组织</translation>
    </message>
    <message>
        <source>MR angio</source>
        <translation>MR 血管</translation>
    </message>
    <message>
        <source>MR bright</source>
        <translation>MR 高亮</translation>
    </message>
    <message>
        <source>MR T1</source>
        <translation>MR T1</translation>
    </message>
    <message>
        <source>MR T2</source>
        <translation>MR T2</translation>
    </message>
    <message>
        <source>MR</source>
        <translation>MR</translation>
    </message>
    <message>
        <source>PET</source>
        <translation>PET</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>超声</translation>
    </message>
    <message>
        <source>making the phantom</source>
        <translation>正在生成体模</translation>
    </message>
    <message>
        <source>unpacking</source>
        <translation>正在解包</translation>
    </message>
    <message>
        <source>comparing contents</source>
        <translation>正在比较内容</translation>
    </message>
    <message>
        <source>the only one whose geometry is plausible</source>
        <translation>唯一几何合理者</translation>
    </message>
    <message>
        <source>the only one that is no overview, capture or reformat</source>
        <translation>唯一不是定位像、截屏或重组者</translation>
    </message>
    <message>
        <source>the only %1</source>
        <translation>唯一的%1</translation>
    </message>
    <message>
        <source>the thinnest %1, %2</source>
        <translation>最薄的%1，%2</translation>
    </message>
    <message>
        <source>of the thinnest ones, %1, the one of most voxels</source>
        <translation>最薄者 (%1) 中体素最多者</translation>
    </message>
    <message>
        <source>the %1 of most voxels</source>
        <translation>体素最多的%1</translation>
    </message>
    <message>
        <source>of equal ones the first by its number, %1</source>
        <translation>同等者中编号最先者，%1</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体数据</translation>
    </message>
    <message>
        <source>stack of slices</source>
        <translation>层面堆叠</translation>
    </message>
    <message>
        <source>image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>reading headers</source>
        <translation>正在读取文件头</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>正在读取层面</translation>
    </message>
    <message>
        <source>filling contours</source>
        <translation>正在填充轮廓</translation>
    </message>
    <message>
        <source>reading segments</source>
        <translation>正在读取分割段</translation>
    </message>
    <message>
        <source>writing segments</source>
        <translation>正在写入分割段</translation>
    </message>
    <message>
        <source>reading voxels</source>
        <translation>正在读取体素</translation>
    </message>
    <message>
        <source>growing the region</source>
        <translation>区域生长中</translation>
    </message>
    <message>
        <source>looking for moved data</source>
        <translation>正在查找被移动的数据</translation>
    </message>
    <message>
        <source>finding the focus</source>
        <translation>正在查找焦点</translation>
    </message>
    <message>
        <source>extracting the surface</source>
        <translation>正在提取表面</translation>
    </message>
    <message>
        <source>smoothing the surface</source>
        <translation>正在平滑表面</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>正在编辑标签</translation>
    </message>
    <message>
        <source>acquired volume</source>
        <translation>采集的体数据</translation>
    </message>
    <message>
        <source>acquired stack of slices</source>
        <translation>采集的层面堆叠</translation>
    </message>
    <message>
        <source>acquired image</source>
        <translation>采集的图像</translation>
    </message>
    <message>
        <source>volume that is no overview, capture or reformat</source>
        <translation>非定位像、截屏或重组的体数据</translation>
    </message>
    <message>
        <source>stack of slices that is no overview, capture or reformat</source>
        <translation>非定位像、截屏或重组的层面堆叠</translation>
    </message>
    <message>
        <source>image that is no overview, capture or reformat</source>
        <translation>非定位像、截屏或重组的图像</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>How deep the focus lies; below 0 prefers views with little in front of it.
vd1 = mean depth of the focus&apos;s pixels / diameter of the model&apos;s sphere</source>
        <translation>焦点的深度；小于 0 时优先选择前方遮挡少的视角。
vd1 = 焦点像素的平均深度 / 模型包围球直径</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>How large the focus is in the picture.
vd2 = pixels of the focus / pixels of the picture</source>
        <translation>焦点在图像中的大小。
vd2 = 焦点像素数 / 图像像素数</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>居中</translation>
    </message>
    <message>
        <source>How near to the middle of the picture it is.
vd3 = 1 − distance of its centroid from the middle / distance of a corner</source>
        <translation>距图像中心的远近。
vd3 = 1 − 质心到中心的距离 / 角到中心的距离</translation>
    </message>
    <message>
        <source>Cut ends</source>
        <translation>扫描断端</translation>
    </message>
    <message>
        <source>Below 0 avoids looking at the focus through a face where the scan cuts the body off.
Share of the focus&apos;s pixels whose rays enter the volume inside the body</source>
        <translation>小于 0 时避免透过扫描截断身体的面观察焦点。
光线在身体内部进入体数据的焦点像素比例</translation>
    </message>
    <message>
        <source>Evenness</source>
        <translation>均匀性</translation>
    </message>
    <message>
        <source>How much of its surface is seen.
Viewpoint entropy −Σ p log p of the seen surface points, over its maximum (Bordoloi, Shen 2005)</source>
        <translation>可见表面的多少。
可见表面点的视点熵 −Σ p log p 与其最大值之比 (Bordoloi, Shen 2005)</translation>
    </message>
    <message>
        <source>Typical</source>
        <translation>典型性</translation>
    </message>
    <message>
        <source>How typical the view is of all views.
1 − Σ p(o|v) log(p(o|v) / p(o)) over its maximum (Viola et al. 2006)</source>
        <translation>该视角在所有视角中的典型程度。
1 − Σ p(o|v) log(p(o|v) / p(o)) 与其最大值之比 (Viola et al. 2006)</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>稳定性</translation>
    </message>
    <message>
        <source>How little changes when the camera moves a bit.
1 − Jensen–Shannon divergence to the eight nearest views</source>
        <translation>相机稍动时变化的大小。
1 − 与八个最近视角的 Jensen–Shannon 散度</translation>
    </message>
    <message>
        <source>Standard view</source>
        <translation>标准视角</translation>
    </message>
    <message>
        <source>How near the view is to anterior, left, superior …: a little decides between equally good views.
Cosine of the angle to the nearest of the six</source>
        <translation>视角与前、左、上等标准方向的接近程度：少量权重即可在同样好的视角间取舍。
与六个方向中最近者夹角的余弦</translation>
    </message>
    <message>
        <source>Not through cut ends</source>
        <translation>不透过断端</translation>
    </message>
    <message>
        <source>No view within 45° of an end of the scan where the body goes on, while another one shows at least two thirds as much of the focus</source>
        <translation>若另一视角至少能显示三分之二的焦点，则不取扫描断端 45° 以内的视角</translation>
    </message>
    <message>
        <source>From around before from above</source>
        <translation>水平环视优先于俯视</translation>
    </message>
    <message>
        <source>From the front, from behind, the left or the right rather than from above or below, where both show about as much</source>
        <translation>显示内容相近时，优先从前、后、左、右而非上、下观察</translation>
    </message>
    <message>
        <source>Thin stacks from the front</source>
        <translation>薄层堆叠取正面</translation>
    </message>
    <message>
        <source>A stack of a few slices, or one much thinner than wide, is seen from the side from which its slices are shown, not edge-on</source>
        <translation>层面很少或厚度远小于宽度的堆叠从显示层面的一侧观察，而非侧边</translation>
    </message>
    <message>
        <source>From the near side</source>
        <translation>取较近一侧</translation>
    </message>
    <message>
        <source>Language (at the next start)</source>
        <translation>语言（下次启动时）</translation>
    </message>
    <message>
        <source>Language of the window&apos;s texts and numbers; it changes when Fenestra starts again</source>
        <translation>窗口文字和数字的语言；重新启动 Fenestra 后生效</translation>
    </message>
    <message>
        <source>Usual side</source>
        <translation>常用方向</translation>
    </message>
    <message>
        <source>How usual the view is: from the front rather than from the side, from behind, from above or below</source>
        <translation>视角的常用程度：正面优先于侧面、背面、上方或下方</translation>
    </message>
    <message>
        <source>Last view</source>
        <translation>上次视角</translation>
    </message>
    <message>
        <source>How near the view is to the present one, so that it does not jump</source>
        <translation>与当前视角的接近程度，避免跳变</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>How well the view shows the structure&apos;s shape around the point: onto what is flat, across what is long</source>
        <translation>视角对该点周围结构形状的显示程度：扁平者取正面，细长者取横向</translation>
    </message>
    <message>
        <source>Unhidden</source>
        <translation>无遮挡</translation>
    </message>
    <message>
        <source>How little hides the structure around the point, before anything is cut away</source>
        <translation>在切除任何组织之前，该点周围结构被遮挡的程度有多小</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>神经学惯例</translation>
    </message>
    <message>
        <source>Axial and coronal slices show the patient&apos;s left on the left; otherwise it is on the right, as radiologists have it</source>
        <translation>轴位和冠状位层面将患者左侧显示在左边；否则在右边，符合放射学惯例</translation>
    </message>
    <message>
        <source>Objects of archives, at most</source>
        <translation>归档对象上限</translation>
    </message>
    <message>
        <source>Disk space for what was retrieved from archive servers: the series used longest ago go first</source>
        <translation>从归档服务器获取内容所用的磁盘空间：最久未用的序列先被移除</translation>
    </message>
    <message>
        <source>GB</source>
        <translation>GB</translation>
    </message>
    <message>
        <source>de-identifying</source>
        <translation>正在去标识</translation>
    </message>
    <message>
        <source>listing files</source>
        <translation>正在列出文件</translation>
    </message>
    <message>
        <source>looking for faces</source>
        <translation>正在查找面部</translation>
    </message>
</context>
<context>
    <name>Slab</name>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>MinIP</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %L2 mm</translation>
    </message>
</context>
<context>
    <name>StructureMenu</name>
    <message>
        <source>Focus on %1</source>
        <translation>以%1为焦点</translation>
    </message>
    <message>
        <source>Take %1 out of the focus</source>
        <translation>将%1移出焦点</translation>
    </message>
    <message>
        <source>Add %1 to the focus</source>
        <translation>将%1加入焦点</translation>
    </message>
    <message>
        <source>Grow a region from here</source>
        <translation>从此处生长区域</translation>
    </message>
    <message>
        <source>Add this to the region</source>
        <translation>将此处加入区域</translation>
    </message>
    <message>
        <source>Take this away from the region</source>
        <translation>将此处移出区域</translation>
    </message>
    <message>
        <source>Crosshair here</source>
        <translation>十字线定位到此处</translation>
    </message>
    <message>
        <source>No focus</source>
        <translation>无焦点</translation>
    </message>
</context>
<context>
    <name>ViewArea</name>
    <message>
        <source>&amp;Five views</source>
        <translation>五个视图(&amp;F)</translation>
    </message>
    <message>
        <source>C&amp;1 and C2</source>
        <translation>C1 与 C2(&amp;1)</translation>
    </message>
    <message>
        <source>&amp;3-D large, three slices</source>
        <translation>大三维视图加三个层面(&amp;3)</translation>
    </message>
    <message>
        <source>&amp;Slices alone</source>
        <translation>仅层面(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Axial large</source>
        <translation>大轴位(&amp;A)</translation>
    </message>
    <message>
        <source>Four: C1 and slices</source>
        <translation>四格：C1 与层面</translation>
    </message>
    <message>
        <source>C1 &amp;beside axial</source>
        <translation>C1 与轴位并列(&amp;B)</translation>
    </message>
</context>
<context>
    <name>WayOut</name>
    <message>
        <source>File → Choose series has the others</source>
        <translation>其余见“文件 → 选择序列”</translation>
    </message>
    <message>
        <source>it holds one volume: open it without a time point</source>
        <translation>其中只有一个体数据：打开时不要指定时间点</translation>
    </message>
    <message>
        <source>open it without naming a series; File → Choose series then lists those that are there</source>
        <translation>打开时不要指定序列；随后“文件 → 选择序列”会列出已有序列</translation>
    </message>
    <message>
        <source>open it as a volume: a dialog asks for the size</source>
        <translation>作为体数据打开：对话框会询问大小</translation>
    </message>
    <message>
        <source>File → Size of the voxels says otherwise</source>
        <translation>可在“文件 → 体素大小”中更正</translation>
    </message>
    <message>
        <source>open it without a size of voxels, which TIFF and raw files need</source>
        <translation>打开时不要指定体素大小，只有 TIFF 和原始文件需要</translation>
    </message>
    <message>
        <source>File → Kind of values says otherwise</source>
        <translation>可在“文件 → 数值类型”中更正</translation>
    </message>
    <message>
        <source>put the file into the folder of its header</source>
        <translation>将文件放入其头文件所在的文件夹</translation>
    </message>
    <message>
        <source>open it as it is stored: Load as is, in the notice about its slices</source>
        <translation>按存储的原样打开：在关于其层面的提示中选择“按原样载入”</translation>
    </message>
    <message>
        <source>DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze and TIFF are recognised by content</source>
        <translation>DICOM、NIfTI、NRRD、MetaImage、MGH、Analyze 和 TIFF 按内容识别</translation>
    </message>
    <message>
        <source>&quot;Hide the table&quot; in the panel Context brings it back</source>
        <translation>“周围组织”面板中的“隐藏检查床”可恢复显示</translation>
    </message>
    <message>
        <source>open a label map with File → Open labels</source>
        <translation>用“文件 → 打开标签”打开标签图</translation>
    </message>
    <message>
        <source>choose one in the panel Focus</source>
        <translation>在“焦点”面板中选择</translation>
    </message>
    <message>
        <source>choose the labels of the focus in the panel Focus</source>
        <translation>在“焦点”面板中选择焦点的标签</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are, or put them beside it</source>
        <translation>用“文件 → 打开会话”重新打开会话（会询问位置），或将其放在会话旁边</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are</source>
        <translation>用“文件 → 打开会话”重新打开会话（会询问位置）</translation>
    </message>
    <message>
        <source>open it without saying how its volume is read</source>
        <translation>打开时不要指定体数据的读取方式</translation>
    </message>
    <message>
        <source>open it without files</source>
        <translation>打开时不要指定文件</translation>
    </message>
    <message>
        <source>raise the tolerance in the panel Focus</source>
        <translation>在“焦点”面板中提高容差</translation>
    </message>
    <message>
        <source>click at another place, or take a point outside away</source>
        <translation>单击其他位置，或去掉一个外部点</translation>
    </message>
    <message>
        <source>select more, or take less away</source>
        <translation>多选一些，或少去掉一些</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Actions</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;User guide</source>
        <translation>用户指南(&amp;U)</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>引导教程(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>按键与鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Fenestra</source>
        <translation>关于 Fenestra(&amp;A)</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>打开文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>打开文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;labels…</source>
        <translation>打开标签(&amp;L)…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Choose series…</source>
        <translation>选择序列…</translation>
    </message>
    <message>
        <source>Open s&amp;ession…</source>
        <translation>打开会话(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>保存会话(&amp;A)</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>会话另存为(&amp;V)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Built-in phantoms</source>
        <translation>内置体模(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Open a folder of &amp;masks…</source>
        <translation>打开掩膜文件夹(&amp;M)…</translation>
    </message>
    <message>
        <source>Open a &amp;table of labels…</source>
        <translation>打开标签表(&amp;T)…</translation>
    </message>
    <message>
        <source>Si&amp;ze of the voxels…</source>
        <translation>体素大小(&amp;Z)…</translation>
    </message>
    <message>
        <source>&amp;Kind of values</source>
        <translation>数值类型(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;CT</source>
        <translation>CT(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;MR</source>
        <translation>MR(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;PET or SPECT</source>
        <translation>PET 或 SPECT(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Ultrasound</source>
        <translation>超声(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Other</source>
        <translation>其他(&amp;O)</translation>
    </message>
    <message>
        <source>Se&amp;gmentations of this series</source>
        <translation>此序列的分割(&amp;G)</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>导出(&amp;X)</translation>
    </message>
    <message>
        <source>A &amp;picture…</source>
        <translation>图像(&amp;P)…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>A &amp;turntable…</source>
        <translation>旋转动画(&amp;T)…</translation>
    </message>
    <message>
        <source>All &amp;labels…</source>
        <translation>全部标签(&amp;L)…</translation>
    </message>
    <message>
        <source>The &amp;focus as labels…</source>
        <translation>焦点存为标签(&amp;F)…</translation>
    </message>
    <message>
        <source>The focus as a &amp;surface…</source>
        <translation>焦点存为表面(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Measures as a table…</source>
        <translation>测量值存为表格(&amp;M)…</translation>
    </message>
    <message>
        <source>%1, name hidden</source>
        <translation>%1，姓名已隐藏</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>清除这些记录</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>画笔(&amp;B)</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>&amp;Opposite brush</source>
        <translation>反向画笔(&amp;O)</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>缩小画笔(&amp;S)</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>放大画笔(&amp;L)</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>复制图像(&amp;C)</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>设置(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Window/level</source>
        <translation>窗宽/窗位(&amp;W)</translation>
    </message>
    <message>
        <source>Of the data</source>
        <translation>按数据</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>CT %1  (%2 / %3)</source>
        <translation>CT %1  (%2 / %3)</translation>
    </message>
    <message>
        <source>By &amp;number…</source>
        <translation>按数值(&amp;N)…</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>反相(&amp;I)</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>距离(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>角度(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>椭圆(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>矩形(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>删除(&amp;L)</translation>
    </message>
    <message>
        <source>Delete all</source>
        <translation>全部删除</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Show measures</source>
        <translation>显示测量(&amp;S)</translation>
    </message>
    <message>
        <source>F&amp;ocus</source>
        <translation>焦点(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;No focus</source>
        <translation>无焦点(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>&amp;Click chooses the focus</source>
        <translation>单击选择焦点(&amp;C)</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Lower tolerance</source>
        <translation>降低容差(&amp;L)</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>&amp;Higher tolerance</source>
        <translation>提高容差(&amp;H)</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>V&amp;erify this picture…</source>
        <translation>验证此图像(&amp;E)…</translation>
    </message>
    <message>
        <source>Computes pixels drawn at random again, in double precision, and states how exact the picture is</source>
        <translation>以双精度重新计算随机抽取的像素，并说明图像的精确程度</translation>
    </message>
    <message>
        <source>All &amp;views</source>
        <translation>全部视图</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Reset la&amp;yout</source>
        <translation>重置布局(&amp;Y)</translation>
    </message>
    <message>
        <source>Li&amp;ght theme</source>
        <translation>浅色主题(&amp;G)</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>后</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>下</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>观察方向(&amp;L)</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>放置相机</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>重置视图(&amp;R)</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Reset &amp;all views</source>
        <translation>重置全部视图(&amp;A)</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Link the 3-D views</source>
        <translation>联动三维视图</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>平行投影(&amp;O)</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>相机动画</translation>
    </message>
    <message>
        <source>&amp;Freeze the opening</source>
        <translation>固定开口(&amp;F)</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Keeps the opening where it is while the cameras move, so that they look into it (%1)</source>
        <translation>相机移动时开口保持原位，从而可以看到开口内部 (%1)</translation>
    </message>
    <message>
        <source>&amp;Crosshair</source>
        <translation>十字线(&amp;C)</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Label &amp;overlay</source>
        <translation>标签叠加(&amp;B)</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
    <message>
        <source>Corner &amp;text</source>
        <translation>四角文字(&amp;T)</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>&amp;Hide the patient</source>
        <translation>隐藏患者信息(&amp;H)</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>&amp;Quality at rest</source>
        <translation>静止时的画质(&amp;Q)</translation>
    </message>
    <message>
        <source>Bound on the error that sampling leaves in a pixel&apos;s colour</source>
        <translation>采样在像素颜色中留下的误差上限</translation>
    </message>
    <message>
        <source>&amp;Slices</source>
        <translation>层面(&amp;S)</translation>
    </message>
    <message>
        <source>Face C&amp;1</source>
        <translation>朝向 C1(&amp;1)</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Face C&amp;2</source>
        <translation>朝向 C2(&amp;2)</translation>
    </message>
    <message>
        <source>&amp;Slab</source>
        <translation>厚层(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Outlines in 3-D</source>
        <translation>三维中的轮廓(&amp;O)</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>&amp;Reset the plane</source>
        <translation>重置平面(&amp;R)</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Reset &amp;all planes</source>
        <translation>重置全部平面(&amp;E)</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>&amp;Next series</source>
        <translation>下一序列(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+PgDown</source>
        <translation>Ctrl+PgDown</translation>
    </message>
    <message>
        <source>Pre&amp;vious series</source>
        <translation>上一序列(&amp;P)</translation>
    </message>
    <message>
        <source>Ctrl+PgUp</source>
        <translation>Ctrl+PgUp</translation>
    </message>
    <message>
        <source>&amp;Close study</source>
        <translation>关闭检查(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Layo&amp;ut of the views</source>
        <translation>视图布局</translation>
    </message>
    <message>
        <source>&amp;One view, the active one</source>
        <translation>单个视图（活动视图）(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>下一视图</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>上一视图</translation>
    </message>
    <message>
        <source>&amp;Keep this layout…</source>
        <translation>保存此布局(&amp;K)…</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>保存此布局</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Flip &amp;left and right</source>
        <translation>左右翻转(&amp;F)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Flip &amp;up and down</source>
        <translation>上下翻转(&amp;U)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Turn by 90°</source>
        <translation>旋转 90°(&amp;T)</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Tru&amp;e size</source>
        <translation>实际大小(&amp;S)</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>This screen does not say how large it is, so that true size cannot be shown.</source>
        <translation>此显示器未报告其尺寸，因此无法按实际大小显示。</translation>
    </message>
    <message>
        <source>&amp;Neurological convention</source>
        <translation>神经学惯例(&amp;N)</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message numerus="yes">
        <source>%n slices a second</source>
        <translation>
            <numerusform>每秒 %n 层</numerusform>
        </translation>
    </message>
    <message>
        <source>Play &amp;faster</source>
        <translation>加快播放(&amp;L)</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Play slo&amp;wer</source>
        <translation>减慢播放(&amp;W)</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Change &amp;keys…</source>
        <translation>更改按键…</translation>
    </message>
    <message>
        <source>%1  (%2 % to %3 % of the values)</source>
        <translation>%1  （数值的 %2 % 至 %3 %）</translation>
    </message>
    <message>
        <source>SUV 0 to %1</source>
        <translation>SUV 0 至 %1</translation>
    </message>
    <message>
        <source>&amp;My windows</source>
        <translation>我的窗口设置(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Keep this window…</source>
        <translation>保存此窗口设置(&amp;K)…</translation>
    </message>
    <message>
        <source>%1  (%2 / %3)</source>
        <translation>%1  (%2 / %3)</translation>
    </message>
    <message>
        <source>Keep this window</source>
        <translation>保存此窗口设置</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>脑</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>腹部</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>纵隔</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>骨</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>肺</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>卒中</translation>
    </message>
    <message>
        <source>Subdural</source>
        <translation>硬膜下</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>肝</translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation>颞骨</translation>
    </message>
    <message>
        <source>Spine, soft tissue</source>
        <translation>脊柱软组织</translation>
    </message>
    <message>
        <source>Spine, bone</source>
        <translation>脊柱骨</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>常用</translation>
    </message>
    <message>
        <source>All but outliers</source>
        <translation>除离群值外全部</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>Bright structures</source>
        <translation>高亮结构</translation>
    </message>
    <message>
        <source>Send to archive…</source>
        <translation>发送到归档…</translation>
    </message>
    <message>
        <source>The open series and its labels, to a server of the panel Archive</source>
        <translation>已打开的序列及其标签，发送到“归档”面板中的服务器</translation>
    </message>
    <message>
        <source>They are kept in</source>
        <translation>它们保存在</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Keep a key image</source>
        <translation>保留关键图像</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Save res&amp;ults…</source>
        <translation>保存结果(&amp;U)…</translation>
    </message>
    <message>
        <source>Measures, segmentations, pictures and key images as DICOM objects, to a folder or an archive</source>
        <translation>将测量、分割、图片和关键图像作为 DICOM 对象保存到文件夹或归档服务器</translation>
    </message>
    <message>
        <source>Arro&amp;w</source>
        <translation>箭头(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>文字(&amp;T)</translation>
    </message>
    <message>
        <source>Change te&amp;xt…</source>
        <translation>更改文字(&amp;X)…</translation>
    </message>
    <message>
        <source>Draw a &amp;path</source>
        <translation>绘制路径(&amp;P)</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Path along the &amp;focus</source>
        <translation>沿焦点的路径(&amp;F)</translation>
    </message>
    <message>
        <source>Open besi&amp;de</source>
        <translation>在旁边打开(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>F&amp;ile…</source>
        <translation>文件(&amp;I)…</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>T&amp;wo studies</source>
        <translation>两个检查(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Link by patient position</source>
        <translation>按患者位置联动(&amp;L)</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>&amp;Match points</source>
        <translation>匹配点(&amp;M)</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>&amp;Forget the pair of points</source>
        <translation>忘记点对(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Other study</source>
        <translation>另一个检查(&amp;O)</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>De-identify…</source>
        <translation>去标识化…</translation>
    </message>
    <message>
        <source>Copies of the open series without what names the patient</source>
        <translation>已打开序列的副本，不含可识别患者的内容</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::AppearancePanel</name>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>光照</translation>
    </message>
    <message>
        <source>Ready-made light: how surfaces give it back, from wherever it comes</source>
        <translation>现成的光照：表面如何反射光线，与光线方向无关</translation>
    </message>
    <message>
        <source>own</source>
        <translation>自定义</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveDock</name>
    <message>
        <source>Archive</source>
        <translation>归档</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveModel</name>
    <message>
        <source>Patient %1</source>
        <translation>患者 %1</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>无姓名</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>检查 %1</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>序列 %1</translation>
    </message>
    <message>
        <source>Born %1</source>
        <translation>出生 %1</translation>
    </message>
    <message>
        <source>Sex %1</source>
        <translation>性别 %1</translation>
    </message>
    <message>
        <source>Accession number %1</source>
        <translation>检查号 %1</translation>
    </message>
    <message>
        <source>Study ID %1</source>
        <translation>检查 ID %1</translation>
    </message>
    <message>
        <source>Part of the body: %1</source>
        <translation>身体部位：%1</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>协议：%1</translation>
    </message>
    <message>
        <source>Patient, study</source>
        <translation>患者，检查</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图像</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchivePanel</name>
    <message>
        <source>No server is entered, so nothing goes over the network. Add the archive server (PACS) that holds your studies; its administrator knows what to enter.</source>
        <translation>尚未登记服务器，因此不使用网络。请添加保存您检查的归档服务器（PACS）；其管理员知道应填写的内容。</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>正在搜索…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>The archive server that is asked</source>
        <translation>要查询的归档服务器</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Asks the server whether it answers (echo), and says what is wrong</source>
        <translation>询问服务器是否应答（echo），并说明问题所在</translation>
    </message>
    <message>
        <source>Servers</source>
        <translation>服务器</translation>
    </message>
    <message>
        <source>Add, edit and remove servers</source>
        <translation>添加、编辑和移除服务器</translation>
    </message>
    <message>
        <source>Add a server…</source>
        <translation>添加服务器…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>编辑…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the server</source>
        <translation>移除该服务器</translation>
    </message>
    <message>
        <source>Remove %1?</source>
        <translation>移除 %1？</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Retrieves the study or series, and opens it once it is whole (double-click, or drag onto a view)</source>
        <translation>获取检查或序列，完整后打开（双击，或拖到视图上）</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>获取</translation>
    </message>
    <message>
        <source>Fetches what is selected into the cache, to be opened later</source>
        <translation>将所选内容取到缓存，以便稍后打开</translation>
    </message>
    <message>
        <source>More…</source>
        <translation>更多…</translation>
    </message>
    <message>
        <source>Asks for more of the studies that match</source>
        <translation>查询更多匹配的检查</translation>
    </message>
    <message>
        <source>Asking %1…</source>
        <translation>正在查询 %1…</translation>
    </message>
    <message>
        <source>%1 answers, in %2 ms.</source>
        <translation>%1 应答，用时 %2 ms。</translation>
    </message>
    <message>
        <source>Nothing matches. Check the spelling; an asterisk stands for any text, as in *jane*.</source>
        <translation>没有匹配。请检查拼写；星号代表任意文本，如 *jane*。</translation>
    </message>
    <message>
        <source>Studies: %1, of patients: %2.</source>
        <translation>检查：%1，患者：%2。</translation>
    </message>
    <message>
        <source>There are more: narrow the search, or ask for more.</source>
        <translation>还有更多：请缩小搜索范围，或查询更多。</translation>
    </message>
    <message>
        <source>The server does not match by some of the fields.</source>
        <translation>服务器不按其中某些字段匹配。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArrivalView</name>
    <message>
        <source>Looks through the slices that have come</source>
        <translation>浏览已到达的层面</translation>
    </message>
    <message>
        <source>Slice of those that have come</source>
        <translation>已到达层面中的一层</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Shows the views again; the retrieval goes on</source>
        <translation>重新显示视图；获取继续进行</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stops the retrieval; what came is kept</source>
        <translation>停止获取；已到达的内容会保留</translation>
    </message>
    <message>
        <source>Not whole: %1 of %2 images of this series are here. The study opens, with its 3-D views, once all are.</source>
        <translation>不完整：此序列的 %2 幅图像中已到达 %1 幅。全部到达后，检查会连同三维视图一起打开。</translation>
    </message>
    <message>
        <source>All images are here. The study is being opened.</source>
        <translation>所有图像均已到达。正在打开检查。</translation>
    </message>
    <message>
        <source>Not whole: frame %1 of %2 is here. The study opens, with its 3-D views, once all are.</source>
        <translation>不完整：%2 幅图像中的第 %1 幅已到达。全部到达后，检查会连同三维视图一起打开。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::BestViews</name>
    <message>
        <source>One of the best viewpoints; click to look from there with C1</source>
        <translation>最佳视点之一；单击即用 C1 从该处观察</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Brush</name>
    <message>
        <source>Nothing is open: choose a focus first</source>
        <translation>尚无开口：请先选择焦点</translation>
    </message>
    <message>
        <source>The opening is switched off</source>
        <translation>开口已关闭</translation>
    </message>
    <message>
        <source>This method cuts nothing away</source>
        <translation>此方法不切除任何组织</translation>
    </message>
    <message>
        <source>Nothing is there</source>
        <translation>此处没有内容</translation>
    </message>
    <message>
        <source>Nothing was removed here</source>
        <translation>此处未切除任何组织</translation>
    </message>
    <message>
        <source>The brush may not cover the focus</source>
        <translation>画笔不得遮挡焦点</translation>
    </message>
    <message>
        <source>Open down to the focus already</source>
        <translation>已开口至焦点</translation>
    </message>
    <message>
        <source>The context&apos;s edges are switched off</source>
        <translation>周围组织边缘已关闭</translation>
    </message>
    <message>
        <source>Edges are drawn over the focus alone</source>
        <translation>仅在焦点上方绘制边缘</translation>
    </message>
    <message>
        <source>switch the opening on</source>
        <translation>打开开口</translation>
    </message>
    <message>
        <source>open instead</source>
        <translation>改为开口</translation>
    </message>
    <message>
        <source>let it cover the focus</source>
        <translation>允许遮挡焦点</translation>
    </message>
    <message>
        <source>restore instead</source>
        <translation>改为恢复</translation>
    </message>
    <message>
        <source>switch the edges on</source>
        <translation>打开边缘</translation>
    </message>
    <message>
        <source>take the adaptive cutaway</source>
        <translation>使用自适应剖切</translation>
    </message>
    <message>
        <source>Open the context</source>
        <translation>打开周围组织</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>周围组织边缘</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>画笔：%1</translation>
    </message>
    <message>
        <source>Space: %1</source>
        <translation>空格键：%1</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %L2 mm</translation>
    </message>
    <message>
        <source>%1 to the surface</source>
        <translation>%1至表面</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::BrushPanel</name>
    <message>
        <source>Restore to the surface</source>
        <translation>恢复至表面</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>可遮挡焦点</translation>
    </message>
    <message>
        <source>In the painted view only</source>
        <translation>仅在所绘视图中</translation>
    </message>
    <message>
        <source>Paint in the 3-D views</source>
        <translation>在三维视图中绘制</translation>
    </message>
    <message>
        <source>The left button paints; Ctrl+left drag still turns the view (P; E for the opposite brush)</source>
        <translation>左键绘制；Ctrl+左键拖动仍可旋转视图（P；E 切换反向画笔）</translation>
    </message>
    <message>
        <source>Restore brings back all that was removed under the brush; otherwise no more than the depth</source>
        <translation>恢复会带回画笔下切除的全部组织；否则不超过设定深度</translation>
    </message>
    <message>
        <source>Otherwise restored tissue never hides the focus</source>
        <translation>否则恢复的组织绝不遮挡焦点</translation>
    </message>
    <message>
        <source>Otherwise a stroke shows in both views</source>
        <translation>否则笔画显示在两个视图中</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>柔和度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>强度</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CacheRow</name>
    <message>
        <source>Move…</source>
        <translation>移动…</translation>
    </message>
    <message>
        <source>Chooses where objects are kept from now on; those of before stay where they are</source>
        <translation>选择今后保存对象的位置；以前的保留在原处</translation>
    </message>
    <message>
        <source>Keep objects of archives in</source>
        <translation>归档对象保存在</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Removes all objects that were retrieved; not while some come in</source>
        <translation>移除所有已获取的对象；有对象正在传入时除外</translation>
    </message>
    <message>
        <source>Remove all objects that were retrieved? The servers still have them, but sessions that refer to them find their data no more.</source>
        <translation>移除所有已获取的对象？服务器上仍有它们，但引用它们的会话将找不到数据。</translation>
    </message>
    <message>
        <source>Clears…</source>
        <translation>正在清空…</translation>
    </message>
    <message>
        <source>Counts…</source>
        <translation>正在统计…</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1，位于 %2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CamerasPanel</name>
    <message>
        <source>Place cameras</source>
        <translation>放置相机</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Look for the best view of the focus and the one that complements it (F5)</source>
        <translation>寻找焦点的最佳视角及其互补视角 (F5)</translation>
    </message>
    <message>
        <source>The two views see &lt;b&gt;%1 %&lt;/b&gt; of the focus&apos;s surface</source>
        <translation>两个视图共可见焦点表面的 &lt;b&gt;%1 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Needs the 3-D views</source>
        <translation>需要三维视图</translation>
    </message>
    <message>
        <source>Looking at the focus from all sides…</source>
        <translation>正在从各个方向观察焦点…</translation>
    </message>
    <message>
        <source>Click a structure on a slice</source>
        <translation>在层面上单击一个结构</translation>
    </message>
    <message>
        <source>Not placed yet for this focus</source>
        <translation>尚未针对此焦点放置</translation>
    </message>
    <message>
        <source>Choose a focus first</source>
        <translation>请先选择焦点</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Carving</name>
    <message>
        <source>Carve: %1</source>
        <translation>雕刻：%1</translation>
    </message>
    <message>
        <source>Bend the plane</source>
        <translation>弯曲平面</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CarvingRows</name>
    <message>
        <source>Restore all</source>
        <translation>全部恢复</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>The left button carves in all views when it is let go; Ctrl+left drag still turns the view</source>
        <translation>松开左键时在所有视图中雕刻；Ctrl+左键拖动仍可旋转视图</translation>
    </message>
    <message>
        <source>Brings back all that was carved away</source>
        <translation>恢复所有被雕刻掉的组织</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ClippingPanel</name>
    <message>
        <source>Crop to a box</source>
        <translation>裁切为长方体</translation>
    </message>
    <message>
        <source>Add a plane</source>
        <translation>添加平面</translation>
    </message>
    <message>
        <source>Cut everything off behind a plane; up to three</source>
        <translation>切除平面后方的一切；最多三个平面</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>翻转</translation>
    </message>
    <message>
        <source>Keep the other side of the plane</source>
        <translation>保留平面的另一侧</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the plane</source>
        <translation>移除平面</translation>
    </message>
    <message>
        <source>Clip nothing</source>
        <translation>不裁剪</translation>
    </message>
    <message>
        <source>Switch off the box, and remove all planes</source>
        <translation>关闭裁剪框并移除所有平面</translation>
    </message>
    <message>
        <source>R – L</source>
        <translation>R – L</translation>
    </message>
    <message>
        <source>A – P</source>
        <translation>A – P</translation>
    </message>
    <message>
        <source>I – S</source>
        <translation>I – S</translation>
    </message>
    <message>
        <source>The patient&apos;s right end of the box</source>
        <translation>裁剪框的患者右侧端</translation>
    </message>
    <message>
        <source>The patient&apos;s left end of the box</source>
        <translation>裁剪框的患者左侧端</translation>
    </message>
    <message>
        <source>The front end of the box</source>
        <translation>裁剪框的前端</translation>
    </message>
    <message>
        <source>The back end of the box</source>
        <translation>裁剪框的后端</translation>
    </message>
    <message>
        <source>The lower end of the box</source>
        <translation>裁剪框的下端</translation>
    </message>
    <message>
        <source>The upper end of the box</source>
        <translation>裁剪框的上端</translation>
    </message>
    <message>
        <source>Drag a plane&apos;s square to move it, and the ball at its arrow to tilt it, in any view</source>
        <translation>在任一视图中拖动平面的方块可移动平面，拖动箭头处的球可倾斜平面</translation>
    </message>
    <message>
        <source>Where the plane lies along its arrow</source>
        <translation>平面沿其箭头方向的位置</translation>
    </message>
    <message>
        <source>From the axial slice</source>
        <translation>取自轴位层面</translation>
    </message>
    <message>
        <source>From the sagittal slice</source>
        <translation>取自矢状位层面</translation>
    </message>
    <message>
        <source>From the coronal slice</source>
        <translation>取自冠状位层面</translation>
    </message>
    <message>
        <source>Facing camera C1</source>
        <translation>朝向相机 C1</translation>
    </message>
    <message>
        <source>3-D pictures show only the inside of a box along the volume&apos;s axes</source>
        <translation>三维图像仅显示沿体数据轴向的长方体内部</translation>
    </message>
    <message>
        <source>As the transfer function</source>
        <translation>按传递函数</translation>
    </message>
    <message>
        <source>Grey, as the slices</source>
        <translation>灰度，同层面</translation>
    </message>
    <message>
        <source>What the cut faces show. Grey takes the window that the slices have now</source>
        <translation>切面的显示内容。灰度采用层面当前的窗宽窗位</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>切面</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>裁切</translation>
    </message>
    <message>
        <source>Flip the clip plane</source>
        <translation>翻转裁剪平面</translation>
    </message>
    <message>
        <source>Remove the clip plane</source>
        <translation>移除裁剪平面</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>移动裁剪平面</translation>
    </message>
    <message>
        <source>Add a clip plane</source>
        <translation>添加裁剪平面</translation>
    </message>
    <message>
        <source>Plane %1, keeps %2</source>
        <translation>平面 %1，保留 %2</translation>
    </message>
    <message>
        <source>Labels that are never clipped are chosen in the list of structures, by their role.</source>
        <translation>不参与裁剪的标签可在结构列表中按角色选择。</translation>
    </message>
    <message>
        <source>Structures that are never clipped: %1</source>
        <translation>不参与裁剪的结构：%1</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>裁剪平面</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ContextLayerPanel</name>
    <message>
        <source>Context edges: %1</source>
        <translation>周围组织边缘：%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CopyRows</name>
    <message>
        <source>Copy the &amp;value</source>
        <translation>复制值(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Copy the rows</source>
        <translation>复制行(&amp;C)</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CutawayPanel</name>
    <message>
        <source>own</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Ready-made border and context edges</source>
        <translation>现成的边框与周围组织边缘</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Smooth edges, by several rays a pixel, are the adaptive cutaway&apos;s alone</source>
        <translation>平滑边缘（每像素多条光线）仅用于自适应剖切</translation>
    </message>
    <message>
        <source>This method has no width: it cuts nothing away</source>
        <translation>此方法没有宽度：它不切除任何组织</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the lens decide on it</source>
        <translation>此方法没有自身宽度：由焦点和透镜决定</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the angle decide on it</source>
        <translation>此方法没有自身宽度：由焦点和角度决定</translation>
    </message>
    <message>
        <source>The line of this method is the rim of its lens</source>
        <translation>此方法的线条是透镜的边缘</translation>
    </message>
    <message>
        <source>This method has no line: it cuts nothing away</source>
        <translation>此方法没有线条：它不切除任何组织</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DeidentifyDialog</name>
    <message>
        <source>removed</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>emptied</source>
        <translation>已清空</translation>
    </message>
    <message>
        <source>replaced by a dummy</source>
        <translation>替换为占位值</translation>
    </message>
    <message>
        <source>replaced by a new UID</source>
        <translation>替换为新的 UID</translation>
    </message>
    <message>
        <source>cleaned</source>
        <translation>已清理</translation>
    </message>
    <message>
        <source>De-identify</source>
        <translation>去标识化</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>Copies of the open series, images: %1</source>
        <translation>已打开序列的副本，图像数：%1</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>所有标签，作为 DICOM 分割</translation>
    </message>
    <message>
        <source>Their names go with the descriptions, unless these are cleaned</source>
        <translation>除非清理描述，否则其名称随描述一并移除</translation>
    </message>
    <message>
        <source>Keep dates and times</source>
        <translation>保留日期和时间</translation>
    </message>
    <message>
        <source>As they are; with them a patient may be found</source>
        <translation>保持原样；借此可能找到患者</translation>
    </message>
    <message>
        <source>Keep UIDs</source>
        <translation>保留 UID</translation>
    </message>
    <message>
        <source>As they are; whoever has the originals can tell which is which</source>
        <translation>保持原样；持有原件者可以对应</translation>
    </message>
    <message>
        <source>Clean descriptions</source>
        <translation>清理描述</translation>
    </message>
    <message>
        <source>Of descriptions, the words stay that say nothing about a person; otherwise they go</source>
        <translation>描述中仅保留与个人无关的词；否则全部移除</translation>
    </message>
    <message>
        <source>Clean graphics</source>
        <translation>清理图形</translation>
    </message>
    <message>
        <source>The shapes of annotations stay; overlays and curves go in any case</source>
        <translation>保留标注的形状；叠加层和曲线始终移除</translation>
    </message>
    <message>
        <source>Remove the face, from a head in CT or MR</source>
        <translation>移除面部（头部 CT 或 MR）</translation>
    </message>
    <message>
        <source>All in front of a plane from the brow to the chin is blanked. Look at the copies, as slices and in 3-D: a nodded or turned head may keep a part of its face, or lose some brain</source>
        <translation>从眉部到下颏的平面之前的全部内容将被清除。请以层面和三维方式检查副本：低头或转头时可能保留部分面部，或丢失部分脑组织</translation>
    </message>
    <message>
        <source>Look at the copies before you give them away: no program finds a name that is written into a picture, or knows whether all of a face is gone.</source>
        <translation>分发前请检查副本：没有程序能找出写入图像的姓名，也无法确认面部是否已完全移除。</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>更改内容</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Becomes</source>
        <translation>变为</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>To a new folder in</source>
        <translation>到新文件夹，位于</translation>
    </message>
    <message>
        <source>A folder named de-identified is made there</source>
        <translation>将在其中创建名为 de-identified 的文件夹</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>到归档服务器</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>服务器对每个对象作出应答</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>服务器</translation>
    </message>
    <message>
        <source>Keep a map in the file</source>
        <translation>将对照表保存到文件</translation>
    </message>
    <message>
        <source>Old and new UIDs and patients&apos; numbers, readable by you alone. Without it nobody can tell which was which</source>
        <translation>新旧 UID 和患者编号，仅您可读。没有它无人能够对应</translation>
    </message>
    <message>
        <source>File of the map</source>
        <translation>对照表文件</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Folder of the copies</source>
        <translation>副本文件夹</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>%1 copies are in %2.</source>
        <translation>%1 个副本位于 %2。</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>副本 %1</translation>
    </message>
    <message>
        <source>Copies without the face: %1. Look at each of them.</source>
        <translation>已移除面部的副本：%1。请逐一检查。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DockFolding</name>
    <message>
        <source>Fold %1</source>
        <translation>折叠%1</translation>
    </message>
    <message>
        <source>Folds this panel to its title, so that others have more room</source>
        <translation>将此面板折叠为标题，为其他面板腾出空间</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Document</name>
    <message>
        <source>%1×%2×%3 · %4×%5×%6 mm</source>
        <translation>%1×%2×%3 · %L4×%L5×%L6 mm</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>焦点</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>传递函数</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>不裁剪</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Size of the region</source>
        <translation>区域大小</translation>
    </message>
    <message>
        <source>Add to the region</source>
        <translation>加入区域</translation>
    </message>
    <message>
        <source>Take away from the region</source>
        <translation>移出区域</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>绘制区域</translation>
    </message>
    <message>
        <source>Erase from the region</source>
        <translation>从区域擦除</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>The focus before still shows, until you open to the region</source>
        <translation>在对该区域开口之前仍显示先前的焦点</translation>
    </message>
    <message>
        <source>Growing the region; the focus before still shows</source>
        <translation>区域正在生长；仍显示先前的焦点</translation>
    </message>
    <message>
        <source>Growing the region; this is a first part</source>
        <translation>区域正在生长；这是第一部分</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Exports</name>
    <message>
        <source>NRRD, with names and colours</source>
        <translation>NRRD，含名称和颜色</translation>
    </message>
    <message>
        <source>DICOM segmentation, with names and colours</source>
        <translation>DICOM 分割，含名称和颜色</translation>
    </message>
    <message>
        <source>NIfTI</source>
        <translation>NIfTI</translation>
    </message>
    <message>
        <source>MetaImage</source>
        <translation>MetaImage</translation>
    </message>
    <message>
        <source>Export all labels</source>
        <translation>导出全部标签</translation>
    </message>
    <message>
        <source>Export the focus as labels</source>
        <translation>将焦点导出为标签</translation>
    </message>
    <message>
        <source>%1 in mm, %2 axes</source>
        <translation>%1（mm，坐标轴 %2）</translation>
    </message>
    <message>
        <source>Export the focus as a surface</source>
        <translation>将焦点导出为表面</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>表格 (CSV)</translation>
    </message>
    <message>
        <source>Export the measures</source>
        <translation>导出测量</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>已写入 %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FileOpener</name>
    <message>
        <source>Open as volume</source>
        <translation>作为体数据打开</translation>
    </message>
    <message>
        <source>Open as labels of this volume</source>
        <translation>作为此体数据的标签打开</translation>
    </message>
    <message>
        <source>Volumes (*.dcm %1);;All files (*)</source>
        <translation>体数据 (*.dcm %1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>打开体数据</translation>
    </message>
    <message>
        <source>Open a DICOM folder</source>
        <translation>打开 DICOM 文件夹</translation>
    </message>
    <message>
        <source>Label maps (*.dcm %1);;All files (*)</source>
        <translation>标签图 (*.dcm %1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a label map</source>
        <translation>打开标签图</translation>
    </message>
    <message>
        <source>Open a folder of masks</source>
        <translation>打开掩膜文件夹</translation>
    </message>
    <message>
        <source>Tables of labels (*.txt *.tsv *.csv *.label *.ctbl *.lut);;All files (*)</source>
        <translation>标签表 (*.txt *.tsv *.csv *.label *.ctbl *.lut);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a table of labels</source>
        <translation>打开标签表</translation>
    </message>
    <message>
        <source>How large the voxels are:</source>
        <translation>体素大小：</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FocusPanel</name>
    <message>
        <source>No labels. Click a structure in a picture, open a label map (Ctrl+L), or choose a range of values below.</source>
        <translation>没有标签。请单击图像中的结构、打开标签图 (Ctrl+L)，或在下方选择数值范围。</translation>
    </message>
    <message>
        <source>Focus on values</source>
        <translation>按数值设焦点</translation>
    </message>
    <message>
        <source>Find a structure</source>
        <translation>查找结构</translation>
    </message>
    <message>
        <source>The focus is everything whose value lies in this range</source>
        <translation>数值在此范围内的一切均为焦点</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Without islands below</source>
        <translation>忽略小于此值的孤岛</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>绘制区域</translation>
    </message>
    <message>
        <source>The left button paints the region in focus in all views; with Shift it erases</source>
        <translation>左键在所有视图中绘制焦点区域；按住 Shift 擦除</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>柔和度</translation>
    </message>
    <message>
        <source>Nothing open</source>
        <translation>未打开数据</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::GuideWindow</name>
    <message>
        <source>Not on this page</source>
        <translation>本页未找到</translation>
    </message>
    <message>
        <source>User guide of Fenestra</source>
        <translation>Fenestra 用户指南</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一个</translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation>Shift+F3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>F3</source>
        <translation>F3</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>在本页查找</translation>
    </message>
    <message>
        <source>Return goes to the next place (Ctrl+F)</source>
        <translation>按 Return 跳到下一处 (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ImportanceList</name>
    <message>
        <source>What hides a label of a higher level is opened for it; what has the same level or a higher one never is. All else has level 0.</source>
        <translation>遮挡较高级别标签的组织会为其打开；级别相同或更高的绝不打开。其余均为级别 0。</translation>
    </message>
    <message>
        <source>Another label…</source>
        <translation>其他标签…</translation>
    </message>
    <message>
        <source>Gives a label that is not in focus a level of importance</source>
        <translation>为不在焦点中的标签设置重要级别</translation>
    </message>
    <message>
        <source>Level of importance</source>
        <translation>重要级别</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyBindings</name>
    <message>
        <source>It is not JSON, from character %1 on: %2.</source>
        <translation>从第 %1 个字符起不是 JSON：%2。</translation>
    </message>
    <message>
        <source>It does not hold Fenestra&apos;s keys: choose a file that Export in this dialog wrote.</source>
        <translation>其中不含 Fenestra 的按键：请选择由此对话框“导出”写出的文件。</translation>
    </message>
    <message>
        <source>It was written by a newer version of Fenestra.</source>
        <translation>它由更新版本的 Fenestra 写出。</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, of &quot;%2&quot;, is no key.</source>
        <translation>“%2”的“%1”不是按键。</translation>
    </message>
    <message>
        <source>%1, of &quot;%2&quot;, is a key of the views.</source>
        <translation>“%2”的 %1 是视图的按键。</translation>
    </message>
    <message>
        <source>%1 is the key of both &quot;%2&quot; and &quot;%3&quot;.</source>
        <translation>%1 同时是“%2”和“%3”的按键。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImages</name>
    <message>
        <source>Key image %1</source>
        <translation>关键图像 %1</translation>
    </message>
    <message>
        <source>Keep a key image</source>
        <translation>保留关键图像</translation>
    </message>
    <message>
        <source>Return to a key image</source>
        <translation>返回关键图像</translation>
    </message>
    <message>
        <source>Rename a key image</source>
        <translation>重命名关键图像</translation>
    </message>
    <message>
        <source>Delete a key image</source>
        <translation>删除关键图像</translation>
    </message>
    <message>
        <source>Move a key image</source>
        <translation>移动关键图像</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImagesPanel</name>
    <message>
        <source>&amp;Keep</source>
        <translation>保留(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>关键图像</translation>
    </message>
    <message>
        <source>Keeps the cameras, slices, crosshair, focus and look as they are now</source>
        <translation>保留当前的相机、层面、十字线、焦点和外观</translation>
    </message>
    <message>
        <source>Moves the key image up</source>
        <translation>将关键图像上移</translation>
    </message>
    <message>
        <source>Moves the key image down</source>
        <translation>将关键图像下移</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeysDialog</name>
    <message>
        <source>Change keys</source>
        <translation>更改按键</translation>
    </message>
    <message>
        <source>Show entries with these words or keys</source>
        <translation>显示含这些词或按键的条目</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>条目</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>&amp;Take it</source>
        <translation>采用(&amp;T)</translation>
    </message>
    <message>
        <source>Gives the key to this entry, and the other one loses it</source>
        <translation>将按键给此条目，另一条目失去它</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>无按键(&amp;N)</translation>
    </message>
    <message>
        <source>As it &amp;was</source>
        <translation>恢复默认(&amp;W)</translation>
    </message>
    <message>
        <source>The key that the entry comes with</source>
        <translation>条目的默认按键</translation>
    </message>
    <message>
        <source>&amp;Key</source>
        <translation>按键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;All as they were</source>
        <translation>全部恢复默认(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>Click into the box and press the key. Changed keys are bold.</source>
        <translation>单击框内并按下按键。更改过的按键以粗体显示。</translation>
    </message>
    <message>
        <source>%1 is a key of the views: no entry can have it.</source>
        <translation>%1 是视图的按键：条目不能使用。</translation>
    </message>
    <message>
        <source>%1 is the key of %2 → %3. Take it?</source>
        <translation>%1 是 %2 → %3 的按键。是否采用？</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>导出按键</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>已写入 %1。</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>无法写入 %1：%2。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>导入按键</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>按键 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>Taken over from %1.</source>
        <translation>已从 %1 采用。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditPanel</name>
    <message>
        <source>Grow</source>
        <translation>扩大</translation>
    </message>
    <message>
        <source>Add what lies within this distance; other labels keep their voxels</source>
        <translation>加入此距离内的体素；其他标签保持其体素</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Remove what lies within this distance of the outside</source>
        <translation>移除距外部此距离内的体素</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>移除孤岛</translation>
    </message>
    <message>
        <source>Remove separate parts smaller than this</source>
        <translation>移除小于此值的孤立部分</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>填充空洞</translation>
    </message>
    <message>
        <source>Add what the label encloses</source>
        <translation>加入被标签包围的部分</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditor</name>
    <message>
        <source>Grow label</source>
        <translation>扩大标签</translation>
    </message>
    <message>
        <source>Shrink label</source>
        <translation>缩小标签</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>填充空洞</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>移除孤岛</translation>
    </message>
    <message>
        <source>Keep region</source>
        <translation>保留区域</translation>
    </message>
    <message>
        <source>All 65535 values that a label may have are in use</source>
        <translation>标签可用的 65535 个值均已使用</translation>
    </message>
    <message>
        <source>Nothing would be left of the label</source>
        <translation>标签将不剩任何体素</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelList</name>
    <message>
        <source>No structure&apos;s name has these words.</source>
        <translation>没有名称包含这些词的结构。</translation>
    </message>
    <message>
        <source>Show the label</source>
        <translation>显示标签</translation>
    </message>
    <message>
        <source>Do not show the label</source>
        <translation>不显示标签</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>标签颜色</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>焦点</translation>
    </message>
    <message>
        <source>What the view opens to</source>
        <translation>视图向其开口的对象</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>不裁剪</translation>
    </message>
    <message>
        <source>Stays outside the crop box and behind clip planes, as part of the context</source>
        <translation>在裁剪框外和裁剪平面后仍保留，作为周围组织的一部分</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>颜色…</translation>
    </message>
    <message>
        <source>The label map&apos;s own colour</source>
        <translation>标签图自带的颜色</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>结构</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelModel</name>
    <message>
        <source>Label %1</source>
        <translation>标签 %1</translation>
    </message>
    <message>
        <source>Label %1. Tick it to open the view to it; double-click to focus on it alone and go there; F2 renames it.</source>
        <translation>标签 %1。勾选可将视图向其开口；双击将其设为唯一焦点并定位；F2 重命名。</translation>
    </message>
    <message>
        <source>Click to choose another colour</source>
        <translation>单击选择其他颜色</translation>
    </message>
    <message>
        <source>Click to show it or not: slices tint what is visible, and 3-D pictures draw it while it is in focus or protected</source>
        <translation>单击切换显示：层面为可见标签着色，三维图像在其为焦点或受保护时绘制</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Focus: what the view opens to</source>
        <translation>焦点：视图向其开口的对象</translation>
    </message>
    <message>
        <source>Opacity of its surface, however thick it is, and of its tint on slices; click to change it. At 0 % it is left out of the 3-D pictures.</source>
        <translation>其表面（与厚度无关）及层面着色的不透明度；单击更改。为 0 % 时三维图像中不显示。</translation>
    </message>
    <message>
        <source>C1 sees %1 of its surface, C2 %2, both together %3: measured where cameras are tried, nearest to these</source>
        <translation>C1 可见其表面的 %1，C2 可见 %2，两者合计 %3：按最接近的候选相机测得</translation>
    </message>
    <message>
        <source>Share of its surface that C1 and C2 see; measured for labels in focus when cameras are placed</source>
        <translation>C1 和 C2 可见的表面比例；放置相机时对焦点中的标签测量</translation>
    </message>
    <message numerus="yes">
        <source>%n label(s) without voxels</source>
        <translation>
            <numerusform>%n 个标签没有体素</numerusform>
        </translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelTable</name>
    <message>
        <source>&amp;Copy all (CSV)</source>
        <translation>全部复制 (CSV)(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>标签表</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Mean, %1</source>
        <translation>平均值，%1</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>Extent, mm</source>
        <translation>范围，mm</translation>
    </message>
    <message>
        <source>Seen, C1</source>
        <translation>可见，C1</translation>
    </message>
    <message>
        <source>Seen, C2</source>
        <translation>可见，C2</translation>
    </message>
    <message>
        <source>Sides of its box along the patient: left to right, front to back, foot to head</source>
        <translation>沿患者方向包围盒的边长：左右、前后、足头</translation>
    </message>
    <message>
        <source>Share of its surface that the camera sees; measured for labels in focus when cameras are placed</source>
        <translation>相机可见的表面比例；放置相机时对焦点中的标签测量</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>标签 %1</translation>
    </message>
    <message>
        <source>This study has no labels. Open some from the File menu, or keep a grown region as a label.</source>
        <translation>此检查没有标签。请从“文件”菜单打开，或将生长的区域保留为标签。</translation>
    </message>
    <message>
        <source>Measuring the labels…</source>
        <translation>正在测量标签…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Save the label table</source>
        <translation>保存标签表</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>表格 (CSV)</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>已写入 %1。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LoadingBar</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MainWindow</name>
    <message>
        <source>Growing the region</source>
        <translation>区域生长中</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>正在编辑标签</translation>
    </message>
    <message>
        <source>Verifying the picture</source>
        <translation>正在验证图像</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>正在打开…</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>%1 was named at the start and is not open.</source>
        <translation>启动时指定的 %1 尚未打开。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Other data</source>
        <translation>其他数据</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>放置相机</translation>
    </message>
    <message>
        <source>The region is %1, which is %2 % of the body. The slices show its outline; open the 3-D views to it?</source>
        <translation>该区域为 %1，占身体的 %2 %。层面显示其轮廓；是否让三维视图向其开口？</translation>
    </message>
    <message>
        <source>The region, %1, has a doubtful border. The slices show its outline; open the 3-D views to it?</source>
        <translation>该区域为 %1，边界存疑。层面显示其轮廓；是否让三维视图向其开口？</translation>
    </message>
    <message>
        <source>Open to it</source>
        <translation>向其开口</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>%1 lies over other labels and took %2 from them; undo brings them back.</source>
        <translation>%1 覆盖其他标签并占去其 %2；撤销可恢复。</translation>
    </message>
    <message>
        <source>There are %1 key images; delete some to keep another.</source>
        <translation>已有 %1 幅关键图像；请删除一些再保留新的。</translation>
    </message>
    <message>
        <source>The patient may lie differently in the two studies: linked without a pair of points, the same coordinates may be other places. Unlink, put both crosshairs onto the same point, and choose Match points; the link is as good as that pair.</source>
        <translation>患者在两个检查中的体位可能不同：没有点对时，相同的坐标可能是不同的位置。请取消联动，将两条十字线放在同一点上，然后选择“匹配点”；联动的准确度取决于该点对。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MeasureMode</name>
    <message>
        <source>Delete measure</source>
        <translation>删除测量</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>删除全部测量</translation>
    </message>
    <message>
        <source>Move measure</source>
        <translation>移动测量</translation>
    </message>
    <message>
        <source>Change text</source>
        <translation>更改文字</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::NoticeBar</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>另外 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>关闭提示</translation>
    </message>
    <message>
        <source>Files…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>Files concerned</source>
        <translation>相关文件</translation>
    </message>
    <message>
        <source>Slices scanned: %1, %2 mm apart for the most part
Planes shown: %3, %4 mm apart
Farthest from its place as shown: %5 mm; with the slices spread evenly: %6 mm
Planes in wide gaps: %7
Voxels outside of what was scanned: %8</source>
        <translation>扫描层面：%1，间距多为 %L2 mm
显示平面：%3，间距 %L4 mm
当前显示与实际位置的最大偏差：%L5 mm；若层面均匀分布：%L6 mm
位于大间隙中的平面：%7
扫描范围之外的体素：%8</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>Geometry report</source>
        <translation>几何报告</translation>
    </message>
    <message>
        <source>Load as is</source>
        <translation>按原样载入</translation>
    </message>
    <message>
        <source>Regularise</source>
        <translation>规则化</translation>
    </message>
    <message>
        <source>Make straight</source>
        <translation>校直</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathCameras</name>
    <message>
        <source>Cameras follow the path</source>
        <translation>相机跟随路径</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathMode</name>
    <message>
        <source>Draw a path</source>
        <translation>绘制路径</translation>
    </message>
    <message>
        <source>Move a point of the path</source>
        <translation>移动路径上的点</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathOpening</name>
    <message>
        <source>Radius of the opening</source>
        <translation>开口半径</translation>
    </message>
    <message>
        <source>Opening along the path</source>
        <translation>沿路径的开口</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureDialog</name>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>Both 3-D views</source>
        <translation>两个三维视图</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>所有视图</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>With crosshair, text and scale</source>
        <translation>含十字线、文字和比例尺</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>保存图像</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>保存旋转动画</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Pictures in a turn</source>
        <translation>每圈图像数</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>每秒图像数</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureExports</name>
    <message>
        <source>Save a picture</source>
        <translation>保存图像</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could turn.</source>
        <translation>屏幕上没有可旋转的三维视图。</translation>
    </message>
    <message>
        <source>PNG, one for each picture</source>
        <translation>PNG，每幅图像一个</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>MP4 影片</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>保存旋转动画</translation>
    </message>
    <message>
        <source>Drawing %1…</source>
        <translation>正在绘制 %1…</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name, or delete the pictures of an earlier turntable.</source>
        <translation>%1 已存在：请换一个名称，或删除先前旋转动画的图像。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>Copied the picture</source>
        <translation>图像已复制</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started; save PNGs instead.</source>
        <translation>无法启动 ffmpeg；请改存 PNG。</translation>
    </message>
    <message>
        <source>ffmpeg could not write %1: %2</source>
        <translation>ffmpeg 无法写入 %1：%2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureMaker</name>
    <message>
        <source>There is no memory for a picture of %1 × %2 pixels.</source>
        <translation>内存不足以绘制 %1 × %2 像素的图像。</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PlacementController</name>
    <message>
        <source>The focus cannot be measured: %1</source>
        <translation>无法测量焦点：%1</translation>
    </message>
    <message>
        <source>No view of that point: %1</source>
        <translation>没有该点的视角：%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PlacementForm</name>
    <message>
        <source>Place the cameras when a focus is chosen</source>
        <translation>选择焦点时放置相机</translation>
    </message>
    <message>
        <source>Second view follows the first</source>
        <translation>第二视图跟随第一视图</translation>
    </message>
    <message>
        <source>Find both views together</source>
        <translation>同时寻找两个视角</translation>
    </message>
    <message>
        <source>The focus</source>
        <translation>焦点</translation>
    </message>
    <message>
        <source>A point clicked on a slice</source>
        <translation>在层面上单击的点</translation>
    </message>
    <message>
        <source>What the cameras look at.
The focus: its best view and one that complements it.
A point clicked on a slice: a click there turns both views to the structure at that point, which needs no label (LiveSync, Kohlmann et al. 2007)</source>
        <translation>相机观察的对象。
焦点：其最佳视角及互补视角。
在层面上单击的点：单击使两个视图转向该点处的结构，无需标签 (LiveSync, Kohlmann et al. 2007)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How far from the point its structure counts</source>
        <translation>距该点多远以内的结构计入</translation>
    </message>
    <message numerus="yes">
        <source>%n views</source>
        <translation>
            <numerusform>%n 个视角</numerusform>
        </translation>
    </message>
    <message>
        <source>Finer near the best</source>
        <translation>最佳视角附近加密</translation>
    </message>
    <message>
        <source>From how many sides the focus is looked at, evenly all around (12·n² HEALPix directions), or ever finer around the best ones</source>
        <translation>从多少个方向观察焦点：均匀环绕（12·n² 个 HEALPix 方向），或在最佳方向附近逐步加密</translation>
    </message>
    <message>
        <source>To its right</source>
        <translation>其右侧</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>全周</translation>
    </message>
    <message>
        <source>Where the second view may be, always 60° to 120° from the first.
To its right: the half sphere c2·a ≥ 0 around the first view&apos;s right axis a. All around: the band |c1·c2| ≤ sin δ</source>
        <translation>第二视角的允许位置，始终与第一视角相差 60° 至 120°。
其右侧：以第一视角右轴 a 为中心的半球 c2·a ≥ 0。全周：带状区 |c1·c2| ≤ sin δ</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>δ: how far the second view may leave the right angle to the first</source>
        <translation>δ：第二视角可偏离与第一视角垂直方向的程度</translation>
    </message>
    <message>
        <source>Choose the two views that together see most of the focus&apos;s surface.
Off: first the best view, then the best one beside it</source>
        <translation>选择共同可见焦点表面最多的两个视角。
关闭：先取最佳视角，再取其旁的最佳视角</translation>
    </message>
    <message>
        <source>What two views are chosen by: w · share of the surface seen + (1 − w) · mean quality of the views</source>
        <translation>两个视角的选择依据：w · 可见表面比例 + (1 − w) · 视角平均质量</translation>
    </message>
    <message>
        <source>When the first view is turned, the second goes to the best view beside it</source>
        <translation>旋转第一视图时，第二视图转到其旁的最佳视角</translation>
    </message>
    <message>
        <source>Cameras for</source>
        <translation>相机对准</translation>
    </message>
    <message>
        <source>Sides tried</source>
        <translation>尝试方向数</translation>
    </message>
    <message>
        <source>Second view</source>
        <translation>第二视角</translation>
    </message>
    <message>
        <source>Off right angle</source>
        <translation>偏离直角</translation>
    </message>
    <message>
        <source>Surface seen</source>
        <translation>可见表面</translation>
    </message>
    <message>
        <source>More weights</source>
        <translation>更多权重</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>作用范围</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PresetPicker</name>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>预设名称</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>导入预设</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>预设 (*.json)</translation>
    </message>
    <message>
        <source>Export the preset</source>
        <translation>导出预设</translation>
    </message>
    <message>
        <source>There is a preset &quot;%1&quot;. Replace it?</source>
        <translation>已有预设“%1”。是否替换？</translation>
    </message>
    <message>
        <source>Delete the preset &quot;%1&quot;?</source>
        <translation>删除预设“%1”？</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>打开传递函数</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>传递函数 (*.json)</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>已编辑</translation>
    </message>
    <message>
        <source>Transfer functions, and your own presets of the whole look</source>
        <translation>传递函数，以及您自己的整体外观预设</translation>
    </message>
    <message>
        <source>Keep, import, export, rename and delete presets</source>
        <translation>保存、导入、导出、重命名和删除预设</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>来自文件…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Keep this look as a preset…</source>
        <translation>将此外观存为预设…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Import a preset…</source>
        <translation>导入预设…</translation>
    </message>
    <message>
        <source>Export this look…</source>
        <translation>导出此外观…</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外观</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ReformatPanel</name>
    <message>
        <source>Dra&amp;w</source>
        <translation>绘制(&amp;W)</translation>
    </message>
    <message>
        <source>Follow the f&amp;ocus</source>
        <translation>跟随焦点(&amp;O)</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>删除(&amp;L)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Click points on the slices; Backspace takes the last away, Enter or a double click ends the path</source>
        <translation>在层面上单击各点；退格键去掉最后一个，回车或双击结束路径</translation>
    </message>
    <message>
        <source>Finds the centre line of the tubular structure in focus</source>
        <translation>求焦点中管状结构的中心线</translation>
    </message>
    <message>
        <source>Deletes the path</source>
        <translation>删除路径</translation>
    </message>
    <message>
        <source>Width of the pictures</source>
        <translation>图像的宽度</translation>
    </message>
    <message>
        <source>Turns the straightened picture about the path</source>
        <translation>使拉直的图像绕路径旋转</translation>
    </message>
    <message>
        <source>Straightened along the path</source>
        <translation>沿路径拉直</translation>
    </message>
    <message>
        <source>Across the path</source>
        <translation>垂直于路径</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Delete the path</source>
        <translation>删除路径</translation>
    </message>
    <message>
        <source>Bring a label or a region into focus first: a vessel, or another tube.</source>
        <translation>请先将一个标签或区域设为焦点：血管或其他管状结构。</translation>
    </message>
    <message>
        <source>Path along the focus</source>
        <translation>沿焦点的路径</translation>
    </message>
    <message>
        <source>The structure in focus is no tube: it is hardly longer than thick. Draw a path instead.</source>
        <translation>焦点中的结构不是管状：长度与粗细相近。请改为绘制路径。</translation>
    </message>
    <message numerus="yes">
        <source>%n points; Enter ends the path</source>
        <translation>
            <numerusform>%n 个点；回车结束路径</numerusform>
        </translation>
    </message>
    <message>
        <source>Finding the centre line…</source>
        <translation>正在求中心线…</translation>
    </message>
    <message>
        <source>Draw a path on the slices, or follow the vessel that is in focus.</source>
        <translation>在层面上绘制路径，或跟随焦点中的血管。</translation>
    </message>
    <message>
        <source>At %1 of %2 mm</source>
        <translation>位于 %1 / %2 mm</translation>
    </message>
    <message>
        <source>Area %1 mm²</source>
        <translation>面积 %1 mm²</translation>
    </message>
    <message>
        <source>Radius %1 mm</source>
        <translation>半径 %1 mm</translation>
    </message>
    <message>
        <source>Reading the structure in focus…</source>
        <translation>正在读取焦点中的结构…</translation>
    </message>
    <message>
        <source>No structure in focus here: no area</source>
        <translation>此处没有焦点结构：无面积</translation>
    </message>
    <message>
        <source>Cameras follow</source>
        <translation>相机跟随</translation>
    </message>
    <message>
        <source>Both cameras keep the place on the path in the middle of their pictures as you move along it</source>
        <translation>沿路径移动时，两台相机都使路径上的位置保持在图像中央</translation>
    </message>
    <message>
        <source>Open along the path</source>
        <translation>沿路径打开</translation>
    </message>
    <message>
        <source>The view opens to a tube around the path, which goes along when the path changes</source>
        <translation>视图打开至路径周围的管状区域；路径改变时它随之移动</translation>
    </message>
    <message>
        <source>Radius of the tube that the view opens to</source>
        <translation>视图打开至的管状区域的半径</translation>
    </message>
    <message>
        <source>The tube around the path is in focus: untick Open along the path, and bring a vessel into focus.</source>
        <translation>路径周围的管状区域是焦点：请取消“沿路径打开”，并将血管设为焦点。</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionGrower</name>
    <message>
        <source>No region grows from there; click elsewhere.</source>
        <translation>无法从该处生长区域；请单击其他位置。</translation>
    </message>
    <message>
        <source>Nothing would be left of the region; it stays as it was.</source>
        <translation>区域将不剩任何体素；保持原状。</translation>
    </message>
    <message>
        <source>That is air, which fills more than half of the volume; click a structure.</source>
        <translation>那是空气，占体数据一半以上；请单击某个结构。</translation>
    </message>
    <message>
        <source>No border holds the region there: it would fill more than half of the volume. Drag a ball around the structure (Shift+drag), or click elsewhere.</source>
        <translation>该处没有边界能约束区域：它会占满体数据一半以上。请围绕结构画球（Shift+拖动），或单击其他位置。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionPanel</name>
    <message>
        <source>Open the 3-D views to it</source>
        <translation>三维视图向其开口</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>标签颜色</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Shift+click adds to the region, Ctrl+click takes away. Shift+drag draws a ball around a structure, which its region does not leave.</source>
        <translation>Shift+单击加入区域，Ctrl+单击移出。Shift+拖动围绕结构画球，其区域不会超出。</translation>
    </message>
    <message>
        <source>How far values may lie from those at the click (Alt+wheel over a picture, keys , and .)</source>
        <translation>数值可偏离单击处的程度（在图像上 Alt+滚轮，按键 , 和 .）</translation>
    </message>
    <message>
        <source>Tolerance: how far values may lie below those at the click</source>
        <translation>容差：数值可低于单击处的程度</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>The tolerance is chosen from the plateaus</source>
        <translation>容差由平台段自动选取</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the ball around the click, which the region does not leave</source>
        <translation>以单击处为中心、区域不超出的球半径</translation>
    </message>
    <message>
        <source>No ball</source>
        <translation>无球</translation>
    </message>
    <message>
        <source>Nothing bounds the region</source>
        <translation>区域不受限制</translation>
    </message>
    <message>
        <source>Within a ball of</source>
        <translation>限于球内，半径</translation>
    </message>
    <message>
        <source>Name of a label</source>
        <translation>标签名称</translation>
    </message>
    <message>
        <source>Keep the region as a label of this study</source>
        <translation>将区域保留为此检查的标签</translation>
    </message>
    <message>
        <source>Region: growing…</source>
        <translation>区域：生长中…</translation>
    </message>
    <message>
        <source>That is %1 % of the body: the 3-D views do not open to it by themselves.</source>
        <translation>占身体的 %1 %：三维视图不会自动向其开口。</translation>
    </message>
    <message>
        <source>The 3-D views do not open to it by themselves.</source>
        <translation>三维视图不会自动向其开口。</translation>
    </message>
    <message>
        <source>Region: %1</source>
        <translation>区域：%1</translation>
    </message>
    <message>
        <source>Region: %1 so far…</source>
        <translation>区域：目前 %1…</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ResultsDialog</name>
    <message>
        <source>Save results</source>
        <translation>保存结果</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>Stopped. Nothing was written; an archive keeps what it had taken.</source>
        <translation>已停止。没有写入任何内容；归档服务器保留已接收的对象。</translation>
    </message>
    <message>
        <source>Measures and the table of labels, as a report</source>
        <translation>测量和标签表，作为报告</translation>
    </message>
    <message>
        <source>A structured report (TID 1500): distances, angles, areas and values of the measures, volume and values of each label, and the segmentation that these refer to</source>
        <translation>结构化报告（TID 1500）：测量的距离、角度、面积和数值，每个标签的体积和数值，以及它们所指的分割</translation>
    </message>
    <message>
        <source>All labels, as a segmentation</source>
        <translation>所有标签，作为分割</translation>
    </message>
    <message>
        <source>With their names and colours</source>
        <translation>包括名称和颜色</translation>
    </message>
    <message>
        <source>The focus, as a segmentation</source>
        <translation>焦点，作为分割</translation>
    </message>
    <message>
        <source>Labels as they are; a region or a range of values as one segment</source>
        <translation>标签保持原样；区域或数值范围作为一个分割</translation>
    </message>
    <message>
        <source>A picture of</source>
        <translation>图片：</translation>
    </message>
    <message>
        <source>A secondary capture, which says what makes the picture less than exact</source>
        <translation>二次捕获图像，其中说明图片为何不完全精确</translation>
    </message>
    <message>
        <source>Views in the picture</source>
        <translation>图片中的视图</translation>
    </message>
    <message>
        <source>A key object selection, which names slices of the series</source>
        <translation>关键对象选择，指明序列中的层面</translation>
    </message>
    <message>
        <source>by the kind of object</source>
        <translation>按对象类型</translation>
    </message>
    <message>
        <source>Description of the series</source>
        <translation>序列描述</translation>
    </message>
    <message>
        <source>To the folder</source>
        <translation>到文件夹</translation>
    </message>
    <message>
        <source>A file for each object</source>
        <translation>每个对象一个文件</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>到归档服务器</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>服务器对每个对象作出应答</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>服务器</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID, also while the window hides them: archives and other programs file them by these.</source>
        <translation>这些对象包含患者姓名和 ID，即使窗口隐藏了它们：归档服务器和其他程序据此归档。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Folder of the results</source>
        <translation>结果文件夹</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, so there is no DICOM study that this could belong to.</source>
        <translation>此检查不是来自 DICOM 文件，因此没有可归属的 DICOM 检查。</translation>
    </message>
    <message>
        <source>Nothing is in focus.</source>
        <translation>没有焦点。</translation>
    </message>
    <message>
        <source>The region in focus is not complete yet.</source>
        <translation>焦点区域尚未完成。</translation>
    </message>
    <message>
        <source>This series was read from an archive file. Unpack it and open the folder.</source>
        <translation>此序列读自压缩文件。请解压后打开文件夹。</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly: what is shown is interpolated between them.</source>
        <translation>此序列的层面间距不均匀：显示的内容是在层面之间插值得到的。</translation>
    </message>
    <message>
        <source>There are no key images (View → Keep a key image).</source>
        <translation>没有关键图像（视图 → 保留关键图像）。</translation>
    </message>
    <message>
        <source>The crosshair of no key image lies in the volume.</source>
        <translation>没有关键图像的十字线位于体积内。</translation>
    </message>
    <message>
        <source>There are neither measures nor labels.</source>
        <translation>既没有测量也没有标签。</translation>
    </message>
    <message>
        <source>There are no labels.</source>
        <translation>没有标签。</translation>
    </message>
    <message>
        <source>No view is on screen.</source>
        <translation>屏幕上没有视图。</translation>
    </message>
    <message>
        <source>Slices of the key images: %1</source>
        <translation>关键图像的层面：%1</translation>
    </message>
    <message>
        <source>Slices of the key images</source>
        <translation>关键图像的层面</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, and archives file by patient and study.</source>
        <translation>此检查不是来自 DICOM 文件，而归档服务器按患者和检查归档。</translation>
    </message>
    <message>
        <source>No server is entered yet (View → Archive).</source>
        <translation>尚未添加服务器（视图 → 归档）。</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Values %1 to %2 %3</source>
        <translation>数值 %1 至 %2 %3</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>正在绘制图片…</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>已写入 %1。</translation>
    </message>
    <message>
        <source>Nothing was sent: %1</source>
        <translation>没有发送任何内容：%1</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>请求归档确认已保存</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb 没有此类确认</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>存储承诺（Storage Commitment）：归档会说明每个对象是否已安全存储。多数归档为此连接我们的地址和端口，期间该端口开放</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>没有对象确认已保存：%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RetrievalRow</name>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Waits for others</source>
        <translation>等待其他任务</translation>
    </message>
    <message>
        <source>Stops…</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>Paused; what came is kept</source>
        <translation>已暂停；已收到的保留</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>完整</translation>
    </message>
    <message>
        <source>Cancels it, and takes it out of the list. What came stays in the cache</source>
        <translation>取消并从列表中移除。已收到的保留在缓存中</translation>
    </message>
    <message>
        <source>Retrieval %1</source>
        <translation>获取 %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Retrievals</name>
    <message>
        <source>The server needs a login.</source>
        <translation>服务器要求登录。</translation>
    </message>
    <message>
        <source>Its server is no longer in the list.</source>
        <translation>其服务器已不在列表中。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SearchForm</name>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Asks the server for the studies that match. Empty fields match all (Return)</source>
        <translation>向服务器查询匹配的检查。空字段匹配全部（回车）</translation>
    </message>
    <message>
        <source>Saved searches</source>
        <translation>已保存的搜索</translation>
    </message>
    <message>
        <source>Searches under a name. A patient&apos;s name, ID and accession number are not saved</source>
        <translation>以名称保存的搜索。患者姓名、ID 和检查号不会保存</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>姓名</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Accession</source>
        <translation>检查号</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>描述</translation>
    </message>
    <message>
        <source>An asterisk stands for any text, a question mark for one character</source>
        <translation>星号代表任意文本，问号代表一个字符</translation>
    </message>
    <message>
        <source>Family name, or &quot;Doe, Jane&quot;: all names that begin so. %1, as in *jane*</source>
        <translation>姓氏，或“Doe, Jane”：以此开头的所有姓名。%1，如 *jane*</translation>
    </message>
    <message>
        <source>The patient&apos;s ID as it is. %1, as in 47*</source>
        <translation>患者 ID 原样。%1，如 47*</translation>
    </message>
    <message>
        <source>The accession number as it is. %1, as in A2024*</source>
        <translation>检查号原样。%1，如 A2024*</translation>
    </message>
    <message>
        <source>All descriptions of studies that hold this text. %1, as in head*</source>
        <translation>包含此文本的所有检查描述。%1，如 head*</translation>
    </message>
    <message>
        <source>The kind of images that the study holds</source>
        <translation>检查所含图像的类型</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>When the study was made</source>
        <translation>检查的日期</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>今天</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>最近 7 天</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>最近 30 天</translation>
    </message>
    <message>
        <source>Last 365 days</source>
        <translation>最近 365 天</translation>
    </message>
    <message>
        <source>From … to</source>
        <translation>从 … 到</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>第一天</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>最后一天</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save this search…</source>
        <translation>保存此搜索…</translation>
    </message>
    <message>
        <source>Save this search</source>
        <translation>保存此搜索</translation>
    </message>
    <message>
        <source>Its name (date, type and description are saved, nothing of a patient):</source>
        <translation>其名称（保存日期、类型和描述，不保存患者信息）：</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>忘记</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SendDialog</name>
    <message>
        <source>Nothing is open.</source>
        <translation>没有打开任何内容。</translation>
    </message>
    <message>
        <source>What is open is not DICOM, and archives keep nothing else.</source>
        <translation>已打开的内容不是 DICOM，而归档只保存 DICOM。</translation>
    </message>
    <message>
        <source>Send to an archive</source>
        <translation>发送到归档</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>The server that gets the objects</source>
        <translation>接收对象的服务器</translation>
    </message>
    <message>
        <source>The open series, images: %1</source>
        <translation>已打开的序列，图像：%1</translation>
    </message>
    <message>
        <source>Its files as they are</source>
        <translation>其文件原样</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>所有标签，作为 DICOM 分割</translation>
    </message>
    <message>
        <source>With their names and colours, for the patient and the series that are open</source>
        <translation>带有名称和颜色，对应已打开的患者和序列</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID: an archive files them by these.</source>
        <translation>对象含有患者姓名和 ID：归档据此归类。</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>服务器</translation>
    </message>
    <message>
        <source>Image %1</source>
        <translation>图像 %1</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>请求归档确认已保存</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb 没有此类确认</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>存储承诺（Storage Commitment）：归档会说明每个对象是否已安全存储。多数归档为此连接我们的地址和端口，期间该端口开放</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>没有对象确认已保存：%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SentAnswers</name>
    <message>
        <source>Object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Answer of the server</source>
        <translation>服务器的应答</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>Accepted: %1 of %2.</source>
        <translation>已接受：%1 / %2。</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>未保存：%1</translation>
    </message>
    <message>
        <source>not confirmed to be kept</source>
        <translation>未确认保存</translation>
    </message>
    <message>
        <source>Confirmed to be kept: %1 of %2.</source>
        <translation>已确认保存：%2 个中的 %1 个。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SeriesPanel</name>
    <message>
        <source>Series</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>患者 %1</translation>
    </message>
    <message>
        <source>Patient without a name</source>
        <translation>无姓名的患者</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 幅图像</translation>
    </message>
    <message numerus="yes">
        <source>%n images</source>
        <translation>
            <numerusform>%n 幅图像</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1，已打开</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open beside</source>
        <translation>在旁边打开</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ServerDialog</name>
    <message>
        <source>Archive server</source>
        <translation>归档服务器</translation>
    </message>
    <message>
        <source>As you call it</source>
        <translation>您对它的称呼</translation>
    </message>
    <message>
        <source>DICOM</source>
        <translation>DICOM</translation>
    </message>
    <message>
        <source>DICOM over TLS</source>
        <translation>DICOM（TLS）</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>What the server speaks; its administrator knows</source>
        <translation>服务器使用的协议；其管理员知道</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Speaks</source>
        <translation>协议</translation>
    </message>
    <message>
        <source>Its name or address in the network</source>
        <translation>其网络名称或地址</translation>
    </message>
    <message>
        <source>The port that it listens on</source>
        <translation>其监听的端口</translation>
    </message>
    <message>
        <source>Its AE title, at most 16 letters and digits</source>
        <translation>其 AE 标题，最多 16 个字母和数字</translation>
    </message>
    <message>
        <source>Our AE title: its administrator enters it at the server</source>
        <translation>我方 AE 标题：由管理员登记到服务器</translation>
    </message>
    <message>
        <source>C-GET, over our connection</source>
        <translation>C-GET，经由我方连接</translation>
    </message>
    <message>
        <source>C-MOVE, the server connects to us</source>
        <translation>C-MOVE，服务器连接我方</translation>
    </message>
    <message>
        <source>How objects come. C-GET needs nothing more; with C-MOVE our address and port are entered at the server, and the port is open while objects come</source>
        <translation>对象的传入方式。C-GET 无需其他设置；使用 C-MOVE 时需在服务器上登记我方地址和端口，传入对象期间端口开放</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>主机</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Its AE title</source>
        <translation>其 AE 标题</translation>
    </message>
    <message>
        <source>Our AE title</source>
        <translation>我方 AE 标题</translation>
    </message>
    <message>
        <source>Retrieve by</source>
        <translation>获取方式</translation>
    </message>
    <message>
        <source>Our address</source>
        <translation>我方地址</translation>
    </message>
    <message>
        <source>Our port</source>
        <translation>我方端口</translation>
    </message>
    <message>
        <source>The address of DICOMweb&apos;s root. A login goes out over https alone</source>
        <translation>DICOMweb 的根地址。登录信息仅经由 https 发送</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>User and password</source>
        <translation>用户名和密码</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>令牌</translation>
    </message>
    <message>
        <source>Who you are to the server</source>
        <translation>您在服务器上的身份</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Certificates that may sign the server&apos;s</source>
        <translation>可签署服务器证书的证书</translation>
    </message>
    <message>
        <source>Certificates in PEM that may sign the server&apos;s, or its own</source>
        <translation>可签署服务器证书的 PEM 证书，或服务器自己的证书</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>我方证书</translation>
    </message>
    <message>
        <source>In PEM, where the server asks for one</source>
        <translation>PEM 格式，用于服务器要求证书时</translation>
    </message>
    <message>
        <source>The key of our certificate</source>
        <translation>我方证书的密钥</translation>
    </message>
    <message>
        <source>In PEM, without a passphrase</source>
        <translation>PEM 格式，无密码短语</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>受信任的证书</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>其密钥</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>选择文件</translation>
    </message>
    <message>
        <source>Certificates and keys (*.pem *.crt *.cer *.key);;All files (*)</source>
        <translation>证书和密钥 (*.pem *.crt *.cer *.key);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Token for %1:</source>
        <translation>%1 的令牌：</translation>
    </message>
    <message>
        <source>Password of %1 for %2:</source>
        <translation>%1 在 %2 的密码：</translation>
    </message>
    <message>
        <source>Address of this machine that the server sends to: objects by C-MOVE, and whether it keeps what it was sent</source>
        <translation>服务器发送到的本机地址：通过 C-MOVE 的对象，以及是否保存了所收到的内容</translation>
    </message>
    <message>
        <source>Port of this machine that the server sends to; it is open while that is waited for</source>
        <translation>服务器发送到的本机端口；仅在等待期间开放</translation>
    </message>
    <message>
        <source>The password or token is asked for when it is needed</source>
        <translation>需要时会询问密码或令牌</translation>
    </message>
    <message>
        <source>Keep the password or token in the key ring</source>
        <translation>将密码或令牌保存在密钥环中</translation>
    </message>
    <message>
        <source>The password or token is kept where the desktop keeps those of other programs, encrypted, and nowhere else. Otherwise it is forgotten when the program ends</source>
        <translation>密码或令牌加密保存在桌面保存其他程序凭据之处，别无他处。否则程序结束时即被遗忘</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Sessions</name>
    <message>
        <source>Sessions</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存的工作</translation>
    </message>
    <message>
        <source>These changes since the last save would be lost. Save them?</source>
        <translation>自上次保存以来的这些更改将会丢失。是否保存？</translation>
    </message>
    <message>
        <source>Where is the data now?</source>
        <translation>数据现在在哪里？</translation>
    </message>
    <message>
        <source>The session&apos;s label map is needed.</source>
        <translation>需要会话的标签图。</translation>
    </message>
    <message>
        <source>The session&apos;s volume is needed.</source>
        <translation>需要会话的体数据。</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>选择文件夹…</translation>
    </message>
    <message>
        <source>The data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>The data&apos;s folder</source>
        <translation>数据文件夹</translation>
    </message>
    <message>
        <source>%1 %2. Say it here:</source>
        <translation>%1 %2。请在此指定：</translation>
    </message>
    <message>
        <source>Fenestra ended before the session was saved. A copy from %1 can be restored.</source>
        <translation>Fenestra 在保存会话之前结束。可恢复 %1 的副本。</translation>
    </message>
    <message>
        <source>Fenestra ended before the work on %1 was saved. A copy from %2 can be restored.</source>
        <translation>Fenestra 在保存 %1 的工作之前结束。可恢复 %2 的副本。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>稍后询问</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>另外 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>保存会话</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>打开会话</translation>
    </message>
    <message>
        <source>The labels that you kept are in no file yet, and reading the data again would drop them. Save the session first.</source>
        <translation>您保留的标签尚未存入文件，重新读取数据会丢失它们。请先保存会话。</translation>
    </message>
    <message>
        <source>The restored work</source>
        <translation>已恢复的工作</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SliceView</name>
    <message>
        <source>Not yet as asked for</source>
        <translation>尚未达到所要求的状态</translation>
    </message>
    <message>
        <source>Interpolated, not scanned</source>
        <translation>插值所得，非扫描</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Radiological</source>
        <translation>放射学惯例</translation>
    </message>
    <message>
        <source>L %1</source>
        <translation>窗位 %L1</translation>
    </message>
    <message>
        <source>W %1</source>
        <translation>窗宽 %L1</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>反相</translation>
    </message>
    <message>
        <source>Oblique, %1° from %2</source>
        <translation>斜位，与%2成 %1°</translation>
    </message>
    <message>
        <source>Faces C1, %1° from %2</source>
        <translation>朝向 C1，与%2成 %1°</translation>
    </message>
    <message>
        <source>Faces C2, %1° from %2</source>
        <translation>朝向 C2，与%2成 %1°</translation>
    </message>
    <message>
        <source>Neurological</source>
        <translation>神经学惯例</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>已翻转</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>已旋转 %1°</translation>
    </message>
    <message>
        <source>true size</source>
        <translation>实际大小</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SpacingDialog</name>
    <message>
        <source>Size of the voxels</source>
        <translation>体素大小</translation>
    </message>
    <message>
        <source>&amp;Across a row</source>
        <translation>沿行方向(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Down a column</source>
        <translation>沿列方向(&amp;D)</translation>
    </message>
    <message>
        <source>From &amp;slice to slice</source>
        <translation>层面之间(&amp;S)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>未给出</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SphereMap</name>
    <message>
        <source>How good each viewpoint is, from dark to bright; click to look from there</source>
        <translation>各视点的优劣，由暗到亮；单击即从该处观察</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StatusBar</name>
    <message>
        <source>Software OpenGL</source>
        <translation>软件 OpenGL</translation>
    </message>
    <message>
        <source>Pictures are smaller while something moves: %1 draws them</source>
        <translation>运动时图像缩小：由 %1 绘制</translation>
    </message>
    <message>
        <source>No OpenGL: slices only</source>
        <translation>无 OpenGL：仅层面</translation>
    </message>
    <message>
        <source>Time until the last picture was on screen, and its sampling</source>
        <translation>最近一幅图像显示所用时间及其采样</translation>
    </message>
    <message>
        <source>Radiological convention</source>
        <translation>放射学惯例</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%L1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>, %1 % size</source>
        <translation>，%1 % 大小</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>神经学惯例</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StrokeList</name>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>全部清除</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>载入…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Tick the strokes to apply</source>
        <translation>勾选要应用的笔画</translation>
    </message>
    <message>
        <source>Adds the strokes of a file</source>
        <translation>添加文件中的笔画</translation>
    </message>
    <message>
        <source>Clear strokes</source>
        <translation>清除笔画</translation>
    </message>
    <message>
        <source>Load brush strokes</source>
        <translation>载入画笔笔画</translation>
    </message>
    <message>
        <source>Brush strokes (*.json)</source>
        <translation>画笔笔画 (*.json)</translation>
    </message>
    <message>
        <source>Brush strokes</source>
        <translation>画笔笔画</translation>
    </message>
    <message>
        <source>Save brush strokes</source>
        <translation>保存画笔笔画</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>删除笔画</translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>删除笔画</translation>
    </message>
    <message>
        <source>Load strokes</source>
        <translation>载入笔画</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StrokeModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>to the surface</source>
        <translation>至表面</translation>
    </message>
    <message>
        <source>%1 mm deep</source>
        <translation>深 %L1 mm</translation>
    </message>
    <message>
        <source>over the focus</source>
        <translation>焦点上方</translation>
    </message>
    <message>
        <source>C%1 only</source>
        <translation>仅 C%1</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>隐藏笔画</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>显示笔画</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyLinkBar</name>
    <message>
        <source>Link</source>
        <translation>联动</translation>
    </message>
    <message>
        <source>The crosshair, scrolling, zoom and turning of one study go along with those of the other, by patient position</source>
        <translation>一个检查的十字线、翻层、缩放和旋转按患者位置随另一个检查一起变化</translation>
    </message>
    <message>
        <source>Match points</source>
        <translation>匹配点</translation>
    </message>
    <message>
        <source>The crosshairs of both studies mark the same point: link the studies by it</source>
        <translation>两个检查的十字线标记同一点：以此联动两个检查</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Forget the pair of points: the same coordinates are the same point</source>
        <translation>忘记点对：相同的坐标即同一点</translation>
    </message>
    <message>
        <source>not linked</source>
        <translation>未联动</translation>
    </message>
    <message>
        <source>linked by patient position</source>
        <translation>按患者位置联动</translation>
    </message>
    <message>
        <source>linked, offset %1, %2, %3 mm</source>
        <translation>已联动，偏移 %1、%2、%3 mm</translation>
    </message>
    <message>
        <source>Offset of the other study to the patient&apos;s left, posterior and superior</source>
        <translation>另一个检查向患者左侧、后方和上方的偏移</translation>
    </message>
    <message>
        <source>Left study</source>
        <translation>左侧检查</translation>
    </message>
    <message>
        <source>Right study</source>
        <translation>右侧检查</translation>
    </message>
    <message>
        <source>%1, active</source>
        <translation>%1，活动</translation>
    </message>
    <message>
        <source>%1 mm apart, where a study ends</source>
        <translation>相距 %1 mm，已到一个检查的边缘</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyNotices</name>
    <message numerus="yes">
        <source>There are %n time points here; this is number %1.</source>
        <translation>
            <numerusform>此处有 %n 个时间点；当前为第 %1 个。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n series here; open is %1.</source>
        <translation>
            <numerusform>此处有 %n 个序列；已打开 %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>A segmentation of this series lies beside it: %1.</source>
        <translation>旁边有此序列的一个分割：%1。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message numerus="yes">
        <source>%n segmentations of this series lie beside it.</source>
        <translation>
            <numerusform>旁边有此序列的 %n 个分割。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TagsPanel</name>
    <message>
        <source>Search tags, names and values</source>
        <translation>搜索属性、名称和值</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>DICOM 属性</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>This study is no DICOM series: its format is %1, which has no DICOM tags.</source>
        <translation>此检查不是 DICOM 序列：其格式为 %1，没有 DICOM 属性。</translation>
    </message>
    <message>
        <source>This series was read from an archive. Unpack it and open the folder to see its tags.</source>
        <translation>此序列读自压缩包。请解压并打开文件夹以查看其属性。</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly. What is shown is interpolated between them, and no file holds it.</source>
        <translation>此序列的层面分布不均匀。所显示的是层面之间的插值，没有文件包含它。</translation>
    </message>
    <message>
        <source>This plane is turned and crosses several files. Reset it (View → Slices), or click another view.</source>
        <translation>此平面已旋转并穿过多个文件。请将其复位（视图 → 层面），或单击其他视图。</translation>
    </message>
    <message>
        <source>The file of this slice cannot be read.</source>
        <translation>无法读取此层面的文件。</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>第 %1 层，共 %2 层</translation>
    </message>
    <message>
        <source>%1, at the crosshair</source>
        <translation>%1，十字线处</translation>
    </message>
    <message>
        <source>1 item</source>
        <translation>1 项</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>已隐藏</translation>
    </message>
    <message>
        <source>Item %1</source>
        <translation>项 %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TolerancePlot</name>
    <message>
        <source>%1 ml</source>
        <translation>%L1 ml</translation>
    </message>
    <message>
        <source>The region&apos;s volume against its tolerance, both logarithmic. A cliff is a leak; green marks where the region hardly changes</source>
        <translation>区域体积随容差的变化（均为对数）。陡崖表示泄漏；绿色表示区域几乎不变</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Tour</name>
    <message>
        <source>End the tour</source>
        <translation>结束教程</translation>
    </message>
    <message>
        <source>One body, five views</source>
        <translation>一个人体，五个视图</translation>
    </message>
    <message>
        <source>Above are two 3-D views, C1 and C2; below are three slices. The torso opens with several structures in focus: what hides them is cut away.</source>
        <translation>上方为两个三维视图 C1 和 C2；下方为三个层面。躯干打开时以多个结构为焦点：遮挡它们的组织已被切除。</translation>
    </message>
    <message>
        <source>Choose a structure</source>
        <translation>选择一个结构</translation>
    </message>
    <message>
        <source>A click on the left kidney in the axial slice makes it the focus. The cameras move to the two views that together see most of it.</source>
        <translation>在轴位层面上单击左肾将其设为焦点。相机移动到共同可见其最多部分的两个视角。</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Drag with the left button in a 3-D view to turn it. The opening follows the kidney; C2 follows C1.</source>
        <translation>在三维视图中按左键拖动即可旋转。开口跟随肾脏；C2 跟随 C1。</translation>
    </message>
    <message>
        <source>Widen the opening</source>
        <translation>扩大开口</translation>
    </message>
    <message>
        <source>The slider Opening in the panel Cutaway sets how far the opening reaches beyond the focus.</source>
        <translation>“剖切”面板中的“开口”滑块设定开口超出焦点的距离。</translation>
    </message>
    <message>
        <source>Bring tissue back</source>
        <translation>恢复组织</translation>
    </message>
    <message>
        <source>The brush (P) paints back what the opening removed: here, tissue above the kidney. Ctrl+Z takes a stroke back.</source>
        <translation>画笔 (P) 可绘回开口移除的组织：此处为肾脏上方的组织。Ctrl+Z 撤销一笔。</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>保存成果</translation>
    </message>
    <message>
        <source>Ctrl+S saves a session with all that you did; Ctrl+E saves a picture, for a slide. F1 opens the user guide.</source>
        <translation>Ctrl+S 将您所做的一切存为会话；Ctrl+E 保存图像，用于幻灯片。F1 打开用户指南。</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 / %2：%3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TransferFunctionEditor</name>
    <message>
        <source>Point</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>所选节点的颜色</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>按数值</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>打开传递函数</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>传递函数 (*.json)</translation>
    </message>
    <message>
        <source>What the plot shows and edits</source>
        <translation>图表显示和编辑的对象</translation>
    </message>
    <message>
        <source>Drag points, or the edges, top and inside of a trapezoid. Double-click adds a point; Delete removes it; the wheel enlarges. The key ? lists all.</source>
        <translation>拖动节点，或梯形的边、顶和内部。双击添加节点；Delete 删除；滚轮放大。按 ? 键列出全部。</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>所选节点的数值</translation>
    </message>
    <message>
        <source>Opacity of 1 mm at the selected point</source>
        <translation>所选节点处 1 mm 的不透明度</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Shows this part of the focus by a function of the values, as the context is shown, in place of one colour and opacity</source>
        <translation>以数值函数显示焦点的这一部分（同周围组织），而非单一颜色和不透明度</translation>
    </message>
    <message>
        <source>From a preset</source>
        <translation>取自预设</translation>
    </message>
    <message>
        <source>Takes the function of a preset for this part of the focus</source>
        <translation>将预设的函数用于焦点的这一部分</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>来自文件…</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TransferFunctionPlot</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Transfer function over the histogram</source>
        <translation>直方图上的传递函数</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>颜色…</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>删除节点</translation>
    </message>
    <message>
        <source>Delete the trapezoid</source>
        <translation>删除梯形</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>添加节点</translation>
    </message>
    <message>
        <source>Add a trapezoid</source>
        <translation>添加梯形</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>按数值</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>显示全部数值</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Verification</name>
    <message>
        <source>Computed again in double precision: %1 pixels, drawn at random (seed %2). Beyond that: %3. Greatest difference: %4/255.</source>
        <translation>以双精度重新计算：%1 个随机抽取的像素（种子 %2）。超出者：%3。最大差异：%4/255。</translation>
    </message>
    <message>
        <source>%1 % of the pixels are within %2/255 of the exact picture: all were computed again.</source>
        <translation>%1 % 的像素与精确图像相差不超过 %2/255：已全部重新计算。</translation>
    </message>
    <message>
        <source>At least %1 % of the pixels are within %2/255 of the exact picture, with %3 % confidence.</source>
        <translation>至少 %1 % 的像素与精确图像相差不超过 %2/255，置信度 %3 %。</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could be verified.</source>
        <translation>屏幕上没有可验证的三维视图。</translation>
    </message>
    <message>
        <source>The picture is verified once it is drawn at full quality.</source>
        <translation>图像以完整画质绘制后即进行验证。</translation>
    </message>
    <message>
        <source>Verify this picture</source>
        <translation>验证此图像</translation>
    </message>
    <message>
        <source>&amp;Save the picture…</source>
        <translation>保存图像(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the picture with its certificate</source>
        <translation>保存图像及其证书</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>已写入 %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewArea</name>
    <message>
        <source>3-D views are not available here.

%1

The slices work without it.</source>
        <translation>此处无法使用三维视图。

%1

层面不受影响。</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewCommands</name>
    <message>
        <source>Standard view</source>
        <translation>标准视角</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>重置视图</translation>
    </message>
    <message>
        <source>Reset views</source>
        <translation>重置全部视图</translation>
    </message>
    <message>
        <source>Freeze the opening</source>
        <translation>固定开口</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::VolumeView</name>
    <message>
        <source>The 3-D views cannot be drawn. %1</source>
        <translation>无法绘制三维视图。%1</translation>
    </message>
    <message>
        <source>The first 3-D picture of this study is being made…</source>
        <translation>正在生成此检查的第一幅三维图像…</translation>
    </message>
    <message>
        <source>Editing the label; the one before still shows</source>
        <translation>正在编辑标签；仍显示之前的标签</translation>
    </message>
    <message>
        <source>Not yet as asked for: the picture is being prepared</source>
        <translation>尚未达到要求：正在准备图像</translation>
    </message>
    <message>
        <source>Waits for the picture</source>
        <translation>等待图像</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>平行</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WaitingBar</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Take back what the pictures do not show yet</source>
        <translation>撤回图像尚未显示的更改</translation>
    </message>
    <message>
        <source>Preparing the picture, %1 s</source>
        <translation>正在准备图像，%1 秒</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WelcomePage</name>
    <message>
        <source>3-D views are not available here; slices work. %1</source>
        <translation>此处无法使用三维视图；层面可用。%1</translation>
    </message>
    <message>
        <source>No graphics card was found: the processor draws the 3-D views, in smaller pictures while something moves. (%1)</source>
        <translation>未找到显卡：由处理器绘制三维视图，运动时图像缩小。(%1)</translation>
    </message>
    <message>
        <source>The graphics card draws the 3-D views. (%1)</source>
        <translation>由显卡绘制三维视图。(%1)</translation>
    </message>
    <message>
        <source>Choose a structure in a CT or MR, and the tissue in front of it opens. &lt;b&gt;Not for diagnostic use.&lt;/b&gt;</source>
        <translation>在 CT 或 MR 中选择一个结构，其前方的组织即会打开。&lt;b&gt;不得用于诊断。&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>最近打开</translation>
    </message>
    <message>
        <source>User guide (F1)</source>
        <translation>用户指南 (F1)</translation>
    </message>
    <message>
        <source>Built-in phantoms</source>
        <translation>内置体模</translation>
    </message>
    <message>
        <source>Bodies made of simple shapes, with every structure labelled. Nobody&apos;s data: try everything on them.</source>
        <translation>由简单形状构成的人体，每个结构都有标签。不是任何人的数据：可随意尝试。</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>引导教程</translation>
    </message>
    <message>
        <source>Clicks through the first minute on the torso phantom, and says at each step what it does.</source>
        <translation>在躯干体模上演示第一分钟的操作，并逐步说明。</translation>
    </message>
    <message>
        <source>Your own data</source>
        <translation>您自己的数据</translation>
    </message>
    <message>
        <source>Drop a folder of DICOM files, or a NIfTI, NRRD or MetaImage file, anywhere in this window.</source>
        <translation>将 DICOM 文件夹，或 NIfTI、NRRD、MetaImage 文件拖放到此窗口任意位置。</translation>
    </message>
    <message>
        <source>Start the tour</source>
        <translation>开始教程</translation>
    </message>
    <message>
        <source>Open a folder…</source>
        <translation>打开文件夹…</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>session</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>study</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>%1 %2, name hidden</source>
        <translation>%1 %2，姓名已隐藏</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WindowLevelDialog</name>
    <message>
        <source>Window and level</source>
        <translation>窗宽和窗位</translation>
    </message>
    <message>
        <source>&amp;Invert: low values bright</source>
        <translation>反相(&amp;I)：低值为亮</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>窗宽(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>窗位(&amp;L)</translation>
    </message>
</context>
</TS>
