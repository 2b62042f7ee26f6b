<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>ClipTool</name>
    <message>
        <source>Crop</source>
        <translation>Recortar</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>Mover el plano de recorte</translation>
    </message>
    <message>
        <source>Tilt the clip plane</source>
        <translation>Inclinar el plano de recorte</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Menu: %1</source>
        <translation>Menú: %1</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas y ratón</translation>
    </message>
    <message>
        <source>What the mouse does in each view, then the keys of the menus.</source>
        <translation>Lo que hace el ratón en cada vista y, después, las teclas de los menús.</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>no disponibles</translation>
    </message>
    <message>
        <source> (shader schedule: %1)</source>
        <translation> (planificación de shaders: %1)</translation>
    </message>
    <message>
        <source>About Fenestra</source>
        <translation>Acerca de Fenestra</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;A medical volume viewer that opens an adaptive cutaway around the structure you want to see.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not for diagnostic use.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. It comes with no warranty.&lt;/p&gt;&lt;p&gt;3-D views: %2&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;Un visor de volúmenes médicos que abre un seccionado adaptativo alrededor de la estructura que se quiere ver.&lt;/p&gt;&lt;p&gt;&lt;b&gt;No apto para uso diagnóstico.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior. Sin garantía alguna.&lt;/p&gt;&lt;p&gt;Vistas 3D: %2&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>crosshair; the label there, or the region around the place, becomes the focus</source>
        <translation>cruz; la etiqueta de allí, o la región en torno al lugar, pasa a ser el foco</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+clic</translation>
    </message>
    <message>
        <source>the label joins or leaves the focus</source>
        <translation>la etiqueta entra en el foco o sale de él</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Arrastrar</translation>
    </message>
    <message>
        <source>window width (across) and level (up and down)</source>
        <translation>ancho de ventana (horizontal) y nivel (vertical)</translation>
    </message>
    <message>
        <source>Ctrl+double-click</source>
        <translation>Ctrl+doble clic</translation>
    </message>
    <message>
        <source>window and level of the data</source>
        <translation>ventana y nivel de los datos</translation>
    </message>
    <message>
        <source>Wheel, arrows</source>
        <translation>Rueda, flechas</translation>
    </message>
    <message>
        <source>next and previous slices</source>
        <translation>cortes siguientes y anteriores</translation>
    </message>
    <message>
        <source>Page up, Page down</source>
        <translation>Re Pág, Av Pág</translation>
    </message>
    <message>
        <source>ten slices</source>
        <translation>diez cortes</translation>
    </message>
    <message>
        <source>Measures, on the slices</source>
        <translation>Medidas, en los cortes</translation>
    </message>
    <message>
        <source>Drag, or clicks</source>
        <translation>Arrastrar o clics</translation>
    </message>
    <message>
        <source>Drag a handle or line</source>
        <translation>Arrastrar un punto o línea</translation>
    </message>
    <message>
        <source>move the end, or the measure</source>
        <translation>mover el extremo o la medida</translation>
    </message>
    <message>
        <source>Right click on it</source>
        <translation>Clic derecho en ella</translation>
    </message>
    <message>
        <source>Clipping, while its tab is in sight</source>
        <translation>Recorte, mientras su pestaña está a la vista</translation>
    </message>
    <message>
        <source>Drag a square</source>
        <translation>Arrastrar un cuadrado</translation>
    </message>
    <message>
        <source>move a face of the box, or a plane</source>
        <translation>mover una cara de la caja o un plano</translation>
    </message>
    <message>
        <source>Drag the ball at an arrow</source>
        <translation>Arrastrar la bola de una flecha</translation>
    </message>
    <message>
        <source>tilt the plane</source>
        <translation>inclinar el plano</translation>
    </message>
    <message>
        <source>Walls of slices, in the 3-D views</source>
        <translation>Paredes de cortes, en las vistas 3D</translation>
    </message>
    <message>
        <source>move the slice of that colour</source>
        <translation>mover el corte de ese color</translation>
    </message>
    <message>
        <source>3-D views</source>
        <translation>Vistas 3D</translation>
    </message>
    <message>
        <source>Drag, arrows</source>
        <translation>Arrastrar, flechas</translation>
    </message>
    <message>
        <source>rotate; the linked view follows</source>
        <translation>girar; la vista enlazada sigue</translation>
    </message>
    <message>
        <source>crosshair to what is seen there; its label or region becomes the focus</source>
        <translation>cruz en lo que se ve allí; su etiqueta o región pasa a ser el foco</translation>
    </message>
    <message>
        <source>its label joins or leaves the focus</source>
        <translation>su etiqueta entra en el foco o sale de él</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoom</translation>
    </message>
    <message>
        <source>A grown region, in all views</source>
        <translation>Región crecida, en todas las vistas</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Mayús+clic</translation>
    </message>
    <message>
        <source>add what is there to the region</source>
        <translation>añadir a la región lo que hay allí</translation>
    </message>
    <message>
        <source>take what is there away from the region</source>
        <translation>quitar de la región lo que hay allí</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Mayús+arrastrar</translation>
    </message>
    <message>
        <source>draw a ball around a structure: the region that grows there stays within it</source>
        <translation>dibujar una bola en torno a una estructura: la región que crece allí queda dentro</translation>
    </message>
    <message>
        <source>Alt+wheel</source>
        <translation>Alt+rueda</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolerancia</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>open the 3-D views to a large or doubtful region, which asks before</source>
        <translation>abrir las vistas 3D a una región grande o dudosa, que pregunta antes</translation>
    </message>
    <message>
        <source>Painting the region, in all views</source>
        <translation>Pintar la región, en todas las vistas</translation>
    </message>
    <message>
        <source>add what the ball passes over</source>
        <translation>añadir aquello por donde pasa la bola</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>quitarlo</translation>
    </message>
    <message>
        <source>Brush, in the 3-D views</source>
        <translation>Pincel, en las vistas 3D</translation>
    </message>
    <message>
        <source>paint</source>
        <translation>pintar</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+arrastrar</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>girar</translation>
    </message>
    <message>
        <source>Shift+wheel, Shift+drag</source>
        <translation>Mayús+rueda, Mayús+arrastrar</translation>
    </message>
    <message>
        <source>depth, or by how much the context&apos;s edges change</source>
        <translation>profundidad, o cuánto cambian las aristas del contexto</translation>
    </message>
    <message>
        <source>Carving, in all views</source>
        <translation>Tallar, en todas las vistas</translation>
    </message>
    <message>
        <source>remove what lies along it, once the button is let go</source>
        <translation>quitar lo que queda a lo largo, al soltar el botón</translation>
    </message>
    <message>
        <source>bend the plane that was laid last</source>
        <translation>curvar el último plano trazado</translation>
    </message>
    <message>
        <source>A transfer function</source>
        <translation>Función de transferencia</translation>
    </message>
    <message>
        <source>Drag a point, or a trapezoid&apos;s edge, top or inside</source>
        <translation>Arrastrar un punto, o el lado, la cima o el interior de un trapecio</translation>
    </message>
    <message>
        <source>move it; with Shift across or up and down alone; Esc takes it back</source>
        <translation>moverlo; con Mayús solo en horizontal o vertical; Esc lo anula</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Doble clic</translation>
    </message>
    <message>
        <source>add a point, or choose the colour of the point there</source>
        <translation>añadir un punto, o elegir el color del punto</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Clic derecho</translation>
    </message>
    <message>
        <source>colour, delete, and add a point or a trapezoid</source>
        <translation>color, eliminar y añadir un punto o un trapecio</translation>
    </message>
    <message>
        <source>Wheel, middle drag</source>
        <translation>Rueda, arrastrar con el botón central</translation>
    </message>
    <message>
        <source>enlarge the values, and move along them</source>
        <translation>ampliar los valores y desplazarse por ellos</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>move the point; with Shift ten times as far, with Alt its whole trapezoid</source>
        <translation>mover el punto; con Mayús diez veces más, con Alt todo su trapecio</translation>
    </message>
    <message>
        <source>Page up, Page down, Home, End</source>
        <translation>Re Pág, Av Pág, Inicio, Fin</translation>
    </message>
    <message>
        <source>choose another point</source>
        <translation>elegir otro punto</translation>
    </message>
    <message>
        <source>Ins, Del, Return</source>
        <translation>Insert, Supr, Intro</translation>
    </message>
    <message>
        <source>add a point, delete the point, choose its colour</source>
        <translation>añadir un punto, eliminarlo, elegir su color</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Todas las vistas</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Arrastrar con el botón central</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>mover la imagen</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>Arrastrar con el botón derecho, Ctrl+rueda</translation>
    </message>
    <message>
        <source>a menu for that place</source>
        <translation>menú para ese lugar</translation>
    </message>
    <message>
        <source>Shift+move</source>
        <translation>Mayús+mover</translation>
    </message>
    <message>
        <source>crosshair follows the mouse</source>
        <translation>la cruz sigue al ratón</translation>
    </message>
    <message>
        <source>show this view alone; Esc shows all</source>
        <translation>mostrar solo esta vista; Esc muestra todas</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Mayús+rueda</translation>
    </message>
    <message>
        <source>thickness of the slab, from the slice alone to 100 mm</source>
        <translation>grosor del bloque, desde el corte solo hasta 100 mm</translation>
    </message>
    <message>
        <source>The crosshair&apos;s lines, on the slices</source>
        <translation>Las líneas de la cruz, en los cortes</translation>
    </message>
    <message>
        <source>Drag a ball</source>
        <translation>Arrastrar una bola</translation>
    </message>
    <message>
        <source>turn the plane of that colour</source>
        <translation>girar el plano de ese color</translation>
    </message>
    <message>
        <source>hold its line to rows, columns and diagonals</source>
        <translation>ajustar su línea a filas, columnas y diagonales</translation>
    </message>
    <message>
        <source>turn both planes</source>
        <translation>girar ambos planos</translation>
    </message>
    <message>
        <source>Outlines of the slices, in the 3-D views</source>
        <translation>Contornos de los cortes, en las vistas 3D</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Inicio, Fin</translation>
    </message>
    <message>
        <source>first and last slice</source>
        <translation>primer y último corte</translation>
    </message>
    <message>
        <source>move the picture; on the body only while clicks choose no focus (Focus menu)</source>
        <translation>mover la imagen; sobre el cuerpo solo si los clics no eligen foco (menú Foco)</translation>
    </message>
    <message>
        <source>What an archive holds</source>
        <translation>Lo que contiene un archivo</translation>
    </message>
    <message>
        <source>Double-click, Return</source>
        <translation>Doble clic, Intro</translation>
    </message>
    <message>
        <source>retrieve the study or series, and open it once it is whole</source>
        <translation>recuperar el estudio o la serie y abrirlo cuando esté completo</translation>
    </message>
    <message>
        <source>Drag onto a view</source>
        <translation>Arrastrar a una vista</translation>
    </message>
    <message>
        <source>retrieve what is selected, and open it once it is whole</source>
        <translation>recuperar lo seleccionado y abrirlo cuando esté completo</translation>
    </message>
    <message>
        <source>DICOM tags and label table</source>
        <translation>Atributos DICOM y tabla de etiquetas</translation>
    </message>
    <message>
        <source>Click on a label</source>
        <translation>Clic en una etiqueta</translation>
    </message>
    <message>
        <source>crosshair into it</source>
        <translation>la cruz dentro de ella</translation>
    </message>
    <message>
        <source>Ctrl+C, right click</source>
        <translation>Ctrl+C, clic derecho</translation>
    </message>
    <message>
        <source>copy the selected rows, or a value</source>
        <translation>copiar las filas seleccionadas o un valor</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Imágenes clave</translation>
    </message>
    <message>
        <source>Click, Return</source>
        <translation>Clic, Intro</translation>
    </message>
    <message>
        <source>go back to it</source>
        <translation>volver a ella</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>cambiar su nombre</translation>
    </message>
    <message>
        <source>draw the measure or arrow whose tool is chosen, then type an arrow&apos;s text; Esc ends it</source>
        <translation>dibujar la medida o la flecha cuya herramienta está elegida y escribir el texto de la flecha; Esc termina</translation>
    </message>
    <message>
        <source>Click, as a text&apos;s tool is chosen</source>
        <translation>Clic, con la herramienta de texto elegida</translation>
    </message>
    <message>
        <source>place a text, and type it</source>
        <translation>colocar un texto y escribirlo</translation>
    </message>
    <message>
        <source>copy and delete; change the text of a mark</source>
        <translation>copiar y eliminar; cambiar el texto de una marca</translation>
    </message>
    <message>
        <source>The path of the curved reformat, on the slices</source>
        <translation>Trayecto del reformateo curvo, en los cortes</translation>
    </message>
    <message>
        <source>Clicks, as it is being drawn</source>
        <translation>Clics, mientras se dibuja</translation>
    </message>
    <message>
        <source>add points; Enter or a double click ends it, Esc drops it</source>
        <translation>añadir puntos; Intro o un doble clic lo termina, Esc lo descarta</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>take the last point away</source>
        <translation>quitar el último punto</translation>
    </message>
    <message>
        <source>The pictures of the curved reformat</source>
        <translation>Imágenes del reformateo curvo</translation>
    </message>
    <message>
        <source>crosshair to that place of the path</source>
        <translation>cruz en ese punto del trayecto</translation>
    </message>
    <message>
        <source>Wheel, arrows, Page, Home and End keys</source>
        <translation>Rueda, flechas, teclas de página, Inicio y Fin</translation>
    </message>
    <message>
        <source>move along the path</source>
        <translation>avanzar por el trayecto</translation>
    </message>
    <message>
        <source>Drag a point</source>
        <translation>Arrastrar un punto</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>moverlo</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>slices are shown up to %1 mm from their true places</source>
        <translation>los cortes se muestran hasta a %1 mm de su lugar real</translation>
    </message>
    <message>
        <source>tilt is made straight: %1 slices are resampled onto %2 planes</source>
        <translation>inclinación corregida: %1 cortes se remuestrean en %2 planos</translation>
    </message>
    <message>
        <source>%1 slices are resampled onto %2 even planes</source>
        <translation>%1 cortes se remuestrean en %2 planos uniformes</translation>
    </message>
    <message>
        <source>this plane was not scanned: it is interpolated across a gap</source>
        <translation>este plano no se adquirió: está interpolado sobre un hueco</translation>
    </message>
    <message>
        <source>%1 of %2 planes are interpolated across gaps</source>
        <translation>%1 de %2 planos están interpolados sobre huecos</translation>
    </message>
    <message>
        <source>places or sizes are assumed, because the file does not give them</source>
        <translation>se suponen posiciones o tamaños que el archivo no da</translation>
    </message>
    <message>
        <source>some values are outside of what the file&apos;s header allows</source>
        <translation>algunos valores están fuera de lo que permite la cabecera</translation>
    </message>
    <message>
        <source>values are rounded to the precision of the program&apos;s numbers</source>
        <translation>los valores se redondean a la precisión de los números del programa</translation>
    </message>
    <message>
        <source>slices are missing</source>
        <translation>faltan cortes</translation>
    </message>
    <message>
        <source>files were left out</source>
        <translation>se omitieron archivos</translation>
    </message>
    <message>
        <source>slices of one place were left out</source>
        <translation>se omitieron cortes del mismo lugar</translation>
    </message>
    <message>
        <source>slices of another size or direction are shown as the first one</source>
        <translation>los cortes de otro tamaño o dirección se muestran como el primero</translation>
    </message>
    <message>
        <source>the data differ from those of the session</source>
        <translation>los datos difieren de los de la sesión</translation>
    </message>
    <message>
        <source>1 file</source>
        <translation>1 archivo</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 archivos</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by 1 plane</source>
        <translation>una parte del volumen está recortada por 1 plano</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by %1 planes</source>
        <translation>una parte del volumen está recortada por %1 planos</translation>
    </message>
    <message>
        <source>1 structure is hidden</source>
        <translation>1 estructura está oculta</translation>
    </message>
    <message>
        <source>%1 structures are hidden</source>
        <translation>%1 estructuras están ocultas</translation>
    </message>
    <message>
        <source>a part of the volume is carved away</source>
        <translation>una parte del volumen está tallada</translation>
    </message>
    <message>
        <source>the scanner&apos;s table is left out</source>
        <translation>se omite la mesa del escáner</translation>
    </message>
    <message>
        <source>parts are moved apart: distances between them do not hold</source>
        <translation>las partes están separadas: las distancias entre ellas no valen</translation>
    </message>
    <message>
        <source>a layer is rolled up: distances on it do not hold</source>
        <translation>una capa está enrollada: las distancias en ella no valen</translation>
    </message>
    <message>
        <source>values are smoothed between voxels</source>
        <translation>los valores se suavizan entre vóxeles</translation>
    </message>
    <message>
        <source>values are smoothed over several voxels</source>
        <translation>los valores se suavizan sobre varios vóxeles</translation>
    </message>
    <message>
        <source>values between voxels follow a cubic spline, which may overshoot</source>
        <translation>los valores entre vóxeles siguen un spline cúbico, que puede sobrepasarlos</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed lightly</source>
        <translation>la superficie de las etiquetas está ligeramente suavizada</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed strongly</source>
        <translation>la superficie de las etiquetas está muy suavizada</translation>
    </message>
    <message>
        <source>a draft while something moves, %1 % of the size</source>
        <translation>un borrador mientras algo se mueve, %1 % del tamaño</translation>
    </message>
    <message>
        <source>the sampling error has no bound (quality: %1)</source>
        <translation>el error de muestreo no tiene cota (calidad: %1)</translation>
    </message>
    <message>
        <source>the sampling error is at most %1/255</source>
        <translation>el error de muestreo es como mucho %L1/255</translation>
    </message>
    <message>
        <source>not verified</source>
        <translation>sin verificar</translation>
    </message>
    <message>
        <source>verified: %1</source>
        <translation>verificada: %1</translation>
    </message>
    <message>
        <source>not yet what was asked for</source>
        <translation>aún no es lo pedido</translation>
    </message>
    <message>
        <source>faithful</source>
        <translation>fiel</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>acotada</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>aproximada</translation>
    </message>
    <message>
        <source>altered</source>
        <translation>alterada</translation>
    </message>
    <message>
        <source>a slab: only the highest value of %1 mm shows</source>
        <translation>un bloque: solo se ve el valor más alto de %1 mm</translation>
    </message>
    <message>
        <source>a slab: only the lowest value of %1 mm shows</source>
        <translation>un bloque: solo se ve el valor más bajo de %1 mm</translation>
    </message>
    <message>
        <source>a slab: the mean of %1 mm shows</source>
        <translation>un bloque: se ve la media de %1 mm</translation>
    </message>
    <message>
        <source>values between voxels are interpolated linearly</source>
        <translation>los valores entre vóxeles se interpolan linealmente</translation>
    </message>
</context>
<context>
    <name>FramePacer</name>
    <message>
        <source>draft</source>
        <translation>borrador</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>error ≤ %1/255</source>
        <translation>error ≤ %L1/255</translation>
    </message>
</context>
<context>
    <name>FunctionTarget</name>
    <message>
        <source>Focus</source>
        <translation>Foco</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Función de transferencia</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexto</translation>
    </message>
    <message>
        <source>Focus: %1</source>
        <translation>Foco: %1</translation>
    </message>
</context>
<context>
    <name>GlSupport</name>
    <message>
        <source>Qt&apos;s offscreen platform has no OpenGL; unset QT_QPA_PLATFORM.</source>
        <translation>La plataforma offscreen de Qt no tiene OpenGL; quite QT_QPA_PLATFORM.</translation>
    </message>
    <message>
        <source>No OpenGL context can be made on this display. Install the graphics driver, or Mesa&apos;s software renderer (Debian: libgl1-mesa-dri); on a remote desktop, start Fenestra there.</source>
        <translation>No se puede crear un contexto OpenGL en esta pantalla. Instale el controlador gráfico o el renderizador por software de Mesa (Debian: libgl1-mesa-dri); en un escritorio remoto, inicie Fenestra allí.</translation>
    </message>
    <message>
        <source>OpenGL cannot draw on this display. On a remote desktop, use one with GLX.</source>
        <translation>OpenGL no puede dibujar en esta pantalla. En un escritorio remoto, use uno con GLX.</translation>
    </message>
    <message>
        <source>%1 (LIBGL_ALWAYS_SOFTWARE=1 in the environment selects it).</source>
        <translation>%1 (LIBGL_ALWAYS_SOFTWARE=1 en el entorno lo selecciona).</translation>
    </message>
</context>
<context>
    <name>LabelName</name>
    <message>
        <source>label %1</source>
        <translation>etiqueta %1</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
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
        <translation>Media %L1 %2</translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>DE %L1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
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
        <translation>Flecha</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
</context>
<context>
    <name>MeasureMenu</name>
    <message>
        <source>Copy this measure</source>
        <translation>Copiar esta medida</translation>
    </message>
    <message>
        <source>Copy all as a table (CSV)</source>
        <translation>Copiar todas como tabla (CSV)</translation>
    </message>
    <message>
        <source>Delete this measure</source>
        <translation>Eliminar esta medida</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>Eliminar todas las medidas</translation>
    </message>
    <message>
        <source>Text of the mark</source>
        <translation>Texto de la marca</translation>
    </message>
    <message>
        <source>Pictures and sessions hold it: name no patient.</source>
        <translation>Las imágenes y sesiones lo contienen: no nombre a ningún paciente.</translation>
    </message>
    <message>
        <source>Change the text…</source>
        <translation>Cambiar el texto…</translation>
    </message>
</context>
<context>
    <name>MethodRows</name>
    <message>
        <source>Levels</source>
        <translation>Niveles</translation>
    </message>
    <message>
        <source>rim</source>
        <extracomment>before the number that says how thin the line around a lens is</extracomment>
        <translation>borde</translation>
    </message>
    <message>
        <source>A</source>
        <comment>axial</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>S</source>
        <comment>sagittal</comment>
        <translation>S</translation>
    </message>
    <message>
        <source>C</source>
        <comment>coronal</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Cortes</translation>
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
        <translation>Axial</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>Focus</source>
        <translation>Foco</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>Recorte</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexto</translation>
    </message>
    <message>
        <source>Context edges</source>
        <translation>Aristas</translation>
    </message>
    <message>
        <source>Cutaway</source>
        <translation>Seccionado</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Series</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>Atributos DICOM</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>Tabla de etiquetas</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Imágenes clave</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Curved reformat</source>
        <translation>Reformateo curvo</translation>
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
        <translation>nacimiento %1</translation>
    </message>
</context>
<context>
    <name>PlacementForm</name>
    <message>
        <source>From the side of the body that the focus is nearer to, rather than through the body, where both show about as much</source>
        <translation>Desde el lado del cuerpo más cercano al foco y no a través del cuerpo, si ambas muestran más o menos lo mismo</translation>
    </message>
</context>
<context>
    <name>PlaneMenu</name>
    <message>
        <source>Slab of the %1 slice</source>
        <translation>Bloque del corte: %1</translation>
    </message>
    <message>
        <source>Thickness in mm, half of it to each side; 0 is the slice alone:</source>
        <translation>Grosor en mm, la mitad a cada lado; 0 es el corte solo:</translation>
    </message>
    <message>
        <source>Off: the slice alone</source>
        <translation>Desactivado: el corte solo</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>Other: %1 mm…</source>
        <translation>Otro: %1 mm…</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Otro…</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Máximo (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Mínimo (MinIP)</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>All slices as this one</source>
        <translation>Todos los cortes como este</translation>
    </message>
    <message>
        <source>Slice faces C1</source>
        <translation>Corte frente a C1</translation>
    </message>
    <message>
        <source>Slice faces C2</source>
        <translation>Corte frente a C2</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Bloque</translation>
    </message>
    <message>
        <source>Reset this slice&apos;s plane</source>
        <translation>Restablecer el plano de este corte</translation>
    </message>
    <message>
        <source>Reset all planes</source>
        <translation>Restablecer todos los planos</translation>
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
        <translation>la mesa del escáner se omite en las imágenes 3-D; los cortes la muestran</translation>
    </message>
    <message>
        <source>the file names no modality; its values (%1 to %2) are taken for Hounsfield units of a CT</source>
        <translation>el archivo no indica modalidad; sus valores (%1 a %2) se toman por unidades Hounsfield de una TC</translation>
    </message>
    <message>
        <source>the file stores no orientation; its axes are taken as right, anterior, superior</source>
        <translation>el archivo no guarda orientación; sus ejes se toman como derecha, anterior, superior</translation>
    </message>
    <message>
        <source>the file does not say where the slice lies in the patient</source>
        <translation>el archivo no dice dónde está el corte en el paciente</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; their Slice Location gives their order and a distance of %1 mm, the place is a guess</source>
        <translation>el archivo no dice dónde están sus cortes en el paciente; su Slice Location da el orden y una distancia de %1 mm, el lugar es una suposición</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; they are shown in their stored order, at a distance that is a guess (%1 mm, %2)</source>
        <translation>el archivo no dice dónde están sus cortes en el paciente; se muestran en el orden guardado, a una distancia supuesta (%1 mm, %2)</translation>
    </message>
    <message>
        <source>no pixel spacing is given; 1 mm is assumed</source>
        <translation>no se indica el tamaño de píxel; se supone 1 mm</translation>
    </message>
    <message>
        <source>the pixel spacing is the detector&apos;s; distances in the patient are smaller</source>
        <translation>el tamaño de píxel es el del detector; las distancias en el paciente son menores</translation>
    </message>
    <message>
        <source>its header has no ElementSpacing; 1 mm is assumed</source>
        <translation>su cabecera no tiene ElementSpacing; se supone 1 mm</translation>
    </message>
    <message>
        <source>its header has no spacings; 1 mm is assumed</source>
        <translation>su cabecera no tiene distancias de vóxel; se supone 1 mm</translation>
    </message>
    <message>
        <source>the file holds %1 volumes (time points or layers); number %2 is shown</source>
        <translation>el archivo contiene %1 volúmenes (instantes o capas); se muestra el número %2</translation>
    </message>
    <message>
        <source>all %1 frames lie at one position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>las %1 imágenes están en una misma posición (instantes o repeticiones, no un volumen más profundo%2); cada una forma un volumen propio: se muestra el número %3</translation>
    </message>
    <message>
        <source>%1 frames lie at each position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>en cada posición hay %1 imágenes (instantes o repeticiones, no un volumen más profundo%2); cada una forma un volumen propio: se muestra el número %3</translation>
    </message>
    <message>
        <source>; told apart by %1</source>
        <translation>; distinguidas por %1</translation>
    </message>
    <message>
        <source>the slices are tilted by %1 degrees against the direction they are stacked in (%2 mm sideways from slice to slice)</source>
        <translation>los cortes están inclinados %1 grados respecto a la dirección en que se apilan (%2 mm de lado de corte a corte)</translation>
    </message>
    <message>
        <source>%1 missing: neighbours lie %2 mm apart, but up to %3 mm between the files named</source>
        <translation>falta o faltan %1: los vecinos están a %2 mm, pero hasta a %3 mm entre los archivos nombrados</translation>
    </message>
    <message>
        <source>the slices lie between %1 mm and %2 mm apart</source>
        <translation>los cortes están separados entre %1 mm y %2 mm</translation>
    </message>
    <message>
        <source>%1 shifted sideways by up to %2 mm from the line that the first and the last one lie on</source>
        <translation>%1 desplazados de lado hasta %2 mm respecto a la línea del primero y el último</translation>
    </message>
    <message>
        <source>%1 with other directions or pixel spacing than the first; shown with those of the first, pixels lie up to %2 mm from their places</source>
        <translation>%1 con otras direcciones o tamaño de píxel que el primero; mostrados como el primero, hay píxeles hasta a %2 mm de su lugar</translation>
    </message>
    <message>
        <source>the volume is sheared, so that every slice lies where it was scanned</source>
        <translation>el volumen está inclinado de modo que cada corte está donde se adquirió</translation>
    </message>
    <message>
        <source>all slices are shown %1 mm apart, up to %2 mm from where they were scanned</source>
        <translation>todos los cortes se muestran a %1 mm, hasta a %2 mm de donde se adquirieron</translation>
    </message>
    <message>
        <source>%1; %2 of the voxels lie outside of what was scanned and hold the least value, %3</source>
        <translation>%1; el %2 de los vóxeles está fuera de lo adquirido y tiene el valor mínimo, %3</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm is interpolated across the gap</source>
        <translation>%1; %2 en un hueco de más de %3 mm se interpola a través del hueco</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm are interpolated across the gap</source>
        <translation>%1; %2 en huecos de más de %3 mm se interpolan a través del hueco</translation>
    </message>
    <message>
        <source>%1 (evenly spread they would lie up to %2 mm from their places)</source>
        <translation>%1 (repartidos por igual estarían hasta a %2 mm de su lugar)</translation>
    </message>
    <message>
        <source>%1, with nothing displaced</source>
        <translation>%1, sin desplazar nada</translation>
    </message>
    <message>
        <source>%1, displaced by up to %2 mm</source>
        <translation>%1, con un desplazamiento de hasta %2 mm</translation>
    </message>
    <message>
        <source>%1, sheared as they were scanned</source>
        <translation>%1, inclinados como se adquirieron</translation>
    </message>
    <message>
        <source>linear interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>la interpolación lineal coloca los cortes en %1 planos a %2 mm</translation>
    </message>
    <message>
        <source>cubic interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>la interpolación cúbica coloca los cortes en %1 planos a %2 mm</translation>
    </message>
    <message>
        <source>%1 left out: the same images (SOP instances) as in other files</source>
        <translation>se omiten %1: las mismas imágenes (instancias SOP) que en otros archivos</translation>
    </message>
    <message>
        <source>%1 of the folder left out: not DICOM</source>
        <translation>se omiten %1 de la carpeta: no son DICOM</translation>
    </message>
    <message>
        <source>%1 left out, unreadable (the first: %2)</source>
        <translation>se omiten %1, ilegibles (el primero: %2)</translation>
    </message>
    <message>
        <source>%1 listed in the DICOMDIR missing</source>
        <translation>faltan %1 del DICOMDIR</translation>
    </message>
    <message>
        <source>%1 left out, at positions that other slices have already</source>
        <translation>se omiten %1, en posiciones que ya tienen otros cortes</translation>
    </message>
    <message>
        <source>%1 of the series put into volumes of their own: %2</source>
        <translation>%1 de la serie puestos en volúmenes propios: %2</translation>
    </message>
    <message>
        <source>another size or pixel spacing</source>
        <translation>otro tamaño o tamaño de píxel</translation>
    </message>
    <message>
        <source>another orientation</source>
        <translation>otra orientación</translation>
    </message>
    <message>
        <source>another frame of reference, frame type or stack</source>
        <translation>otro sistema de referencia, tipo de imagen o pila</translation>
    </message>
    <message>
        <source>%1 slices have a Series UID each; they agree in study and kind and lie evenly, and are taken for one series</source>
        <translation>%1 cortes tienen cada uno un UID de serie; coinciden en estudio y tipo y están repartidos por igual, y se toman por una serie</translation>
    </message>
    <message>
        <source>%1 left out: %2</source>
        <translation>se omiten %1: %2</translation>
    </message>
    <message>
        <source>the focus has no voxels in this volume</source>
        <translation>el foco no tiene vóxeles en este volumen</translation>
    </message>
    <message>
        <source>the volume %1 is not what it was when the session was saved</source>
        <translation>el volumen %1 no es el que era al guardar la sesión</translation>
    </message>
    <message>
        <source>the label map %1 is not what it was when the session was saved</source>
        <translation>el mapa de etiquetas %1 no es el que era al guardar la sesión</translation>
    </message>
    <message>
        <source>the volume was found at %1, no longer at %2</source>
        <translation>el volumen se encontró en %1, ya no en %2</translation>
    </message>
    <message>
        <source>the label map was found at %1, no longer at %2</source>
        <translation>el mapa de etiquetas se encontró en %1, ya no en %2</translation>
    </message>
    <message>
        <source>%1 (in %2 of %3 slices)</source>
        <translation>%1 (en %2 de %3 cortes)</translation>
    </message>
    <message>
        <source>%1 file</source>
        <translation>%1 archivo</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 archivos</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>%1 corte</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 cortes</translation>
    </message>
    <message>
        <source>%1 plane</source>
        <translation>%1 plano</translation>
    </message>
    <message>
        <source>%1 planes</source>
        <translation>%1 planos</translation>
    </message>
</context>
<context>
    <name>Region</name>
    <message>
        <source>Its border is clear: values change by %1 there.</source>
        <translation>Su límite es claro: allí los valores cambian en %1.</translation>
    </message>
    <message>
        <source>Its border is fair: values change by %1 there.</source>
        <translation>Su límite es aceptable: allí los valores cambian en %1.</translation>
    </message>
    <message>
        <source>It is doubtful: nearly any other tolerance makes it far larger or smaller. Check its outline on the slices.</source>
        <translation>Es dudosa: casi cualquier otra tolerancia la hace mucho mayor o menor. Compruebe su contorno en los cortes.</translation>
    </message>
    <message>
        <source>It is doubtful: another region here, far larger or smaller, is nearly as clear. Check its outline on the slices.</source>
        <translation>Es dudosa: otra región en este lugar, mucho mayor o menor, es casi igual de clara. Compruebe su contorno en los cortes.</translation>
    </message>
    <message>
        <source>It is doubtful: it spreads from a thin part at the click into a thicker one. Check its outline on the slices.</source>
        <translation>Es dudosa: se extiende desde una parte delgada donde se hizo clic a otra más gruesa. Compruebe su contorno en los cortes.</translation>
    </message>
    <message>
        <source>It is doubtful: it is a flat tube, as two vessels side by side are. Check its outline on the slices.</source>
        <translation>Es dudosa: es un tubo aplanado, como dos vasos uno junto al otro. Compruebe su contorno en los cortes.</translation>
    </message>
    <message>
        <source>It is doubtful: values change by only %1 along its border. Check its outline on the slices.</source>
        <translation>Es dudosa: en su límite los valores cambian solo en %1. Compruebe su contorno en los cortes.</translation>
    </message>
    <message>
        <source>the left</source>
        <translation>la izquierda</translation>
    </message>
    <message>
        <source>the right</source>
        <translation>la derecha</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>atrás</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>delante</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>la cabeza</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>los pies</translation>
    </message>
    <message>
        <source>on all sides</source>
        <translation>en todas las direcciones</translation>
    </message>
    <message>
        <source>towards %1</source>
        <translation>hacia %1</translation>
    </message>
    <message>
        <source>towards %1 and %2</source>
        <translation>hacia %1 y %2</translation>
    </message>
    <message>
        <source>Values: %1 ± %2.</source>
        <translation>Valores: %1 ± %2.</translation>
    </message>
    <message>
        <source>Next leak: at %1 to %2, %3.</source>
        <translation>Próxima fuga: con %1 a %2, %3.</translation>
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
        <translation>El controlador gráfico rechaza una parte de Fenestra (%1). Actualice el controlador o inicie Fenestra con LIBGL_ALWAYS_SOFTWARE=1 en el entorno.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Close other programs, or open a smaller volume.</source>
        <translation>No hay memoria suficiente para esta imagen. Cierre otros programas o abra un volumen menor.</translation>
    </message>
</context>
<context>
    <name>Results</name>
    <message>
        <source>Focus</source>
        <translation>Foco</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Segments of the measures</source>
        <translation>Segmentos de las medidas</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Imágenes clave</translation>
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
        <translation>cada %1</translation>
    </message>
    <message>
        <source>%1, every %2</source>
        <translation>%1, cada %2</translation>
    </message>
    <message>
        <source>time point %1 of %2</source>
        <translation>instante %1 de %2</translation>
    </message>
    <message>
        <source>Series without a name</source>
        <translation>Serie sin nombre</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Estudio %1</translation>
    </message>
</context>
<context>
    <name>ServerEntry</name>
    <message>
        <source>The server&apos;s AE title has 1 to 16 letters and digits; its administrator knows it.</source>
        <translation>El título AE del servidor tiene de 1 a 16 letras y cifras; su administrador lo conoce.</translation>
    </message>
    <message>
        <source>Our AE title has 1 to 16 letters and digits; the server must know it.</source>
        <translation>El título AE propio tiene de 1 a 16 letras y cifras; el servidor debe conocerlo.</translation>
    </message>
    <message>
        <source>The host is a name or an address, such as pacs.hospital or 192.168.1.5.</source>
        <translation>El host es un nombre o una dirección, como pacs.hospital o 192.168.1.5.</translation>
    </message>
    <message>
        <source>C-MOVE needs a port of ours that is entered at the server.</source>
        <translation>C-MOVE necesita un puerto propio que esté registrado en el servidor.</translation>
    </message>
    <message>
        <source>TLS needs the file of the certificates that may sign the server&apos;s, in PEM.</source>
        <translation>TLS necesita el archivo PEM de los certificados que pueden firmar el del servidor.</translation>
    </message>
    <message>
        <source>Our certificate needs its key, and the key its certificate.</source>
        <translation>El certificado propio necesita su clave, y la clave su certificado.</translation>
    </message>
    <message>
        <source>The address is that of DICOMweb&apos;s root, such as https://pacs.hospital/dicom-web.</source>
        <translation>La dirección es la de la raíz de DICOMweb, como https://pacs.hospital/dicom-web.</translation>
    </message>
    <message>
        <source>A login with a password needs the user&apos;s name.</source>
        <translation>Un acceso con contraseña necesita el nombre del usuario.</translation>
    </message>
    <message>
        <source>This desktop has no key ring that runs, so the password or token is not kept.</source>
        <translation>En este escritorio no funciona ningún llavero, así que la contraseña o el token no se guarda.</translation>
    </message>
    <message>
        <source>The key ring was not opened, so the password or token is neither read nor kept.</source>
        <translation>El llavero no se abrió, así que la contraseña o el token ni se lee ni se guarda.</translation>
    </message>
    <message>
        <source>The key ring cannot be used: %1</source>
        <translation>No se puede usar el llavero: %1</translation>
    </message>
    <message>
        <source>Waiting for the key ring of the desktop…</source>
        <translation>Esperando al llavero del escritorio…</translation>
    </message>
    <message>
        <source>Go on without</source>
        <translation>Seguir sin él</translation>
    </message>
    <message>
        <source>The key ring was not waited for.</source>
        <translation>No se esperó al llavero.</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>Light theme</source>
        <translation>Tema claro</translation>
    </message>
    <message>
        <source>Light colours around the pictures, for bright rooms</source>
        <translation>Colores claros en torno a las imágenes, para salas luminosas</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>Animar las cámaras</translation>
    </message>
    <message>
        <source>Cameras fly to where they are placed instead of jumping there</source>
        <translation>Las cámaras vuelan a su sitio en lugar de saltar</translation>
    </message>
    <message>
        <source>While something moves</source>
        <translation>Mientras algo se mueve</translation>
    </message>
    <message>
        <source>Pictures a second to aim at: more of them are smaller on a slow machine. At rest they always have full quality</source>
        <translation>Imágenes por segundo deseadas: más imágenes son menores en un equipo lento. En reposo siempre tienen plena calidad</translation>
    </message>
    <message>
        <source>pictures/s</source>
        <translation>imágenes/s</translation>
    </message>
    <message>
        <source>Background of new data</source>
        <translation>Fondo de datos nuevos</translation>
    </message>
    <message>
        <source>Colour behind the volume when data are opened without a session</source>
        <translation>Color tras el volumen cuando se abren datos sin sesión</translation>
    </message>
    <message>
        <source>Unit of new openings</source>
        <translation>Unidad de aberturas nuevas</translation>
    </message>
    <message>
        <source>What the widths of the opening are in when data are opened without a session</source>
        <translation>En qué se miden los anchos de la abertura cuando se abren datos sin sesión</translation>
    </message>
    <message>
        <source>Hide the patient</source>
        <translation>Ocultar al paciente</translation>
    </message>
    <message>
        <source>No patient and no study in corner texts, and no folder that may be named after them in the recent list and in what file dialogs remember</source>
        <translation>Ni paciente ni estudio en los textos de las esquinas, ni carpetas que puedan llevar su nombre en la lista de recientes ni en lo que recuerdan los diálogos de archivos</translation>
    </message>
    <message>
        <source>Remember recent data</source>
        <translation>Recordar datos recientes</translation>
    </message>
    <message>
        <source>List the folders and files opened last in the File menu</source>
        <translation>Muestra en el menú Archivo las carpetas y archivos abiertos por última vez</translation>
    </message>
    <message>
        <source>Keep a copy of unsaved work</source>
        <translation>Guardar copia del trabajo sin guardar</translation>
    </message>
    <message>
        <source>Every minute, to be offered after a crash</source>
        <translation>Cada minuto, para ofrecerla tras un fallo</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>How the view is opened to the focus</source>
        <translation>Cómo se abre la vista al foco</translation>
    </message>
    <message>
        <source>Adaptive cutaway</source>
        <translation>Seccionado adaptativo</translation>
    </message>
    <message>
        <source>An opening around the focus that rises to the surface over a width that you choose: the method of this program</source>
        <translation>Una abertura en torno al foco que sube hasta la superficie en un ancho que se elige: el método de este programa</translation>
    </message>
    <message>
        <source>Deformable cutting plane</source>
        <translation>Plano de corte deformable</translation>
    </message>
    <message>
        <source>Nothing opens by itself: a plane that you lay through a stroke and bend by dragging removes one side of it (Konrad-Verse, Preim and Littmann 2004)</source>
        <translation>Nada se abre por sí solo: un plano que se traza con un trazo y se curva arrastrando quita uno de sus lados (Konrad-Verse, Preim y Littmann 2004)</translation>
    </message>
    <message>
        <source>ClearView</source>
        <translation>ClearView</translation>
    </message>
    <message>
        <source>A lens over the focus through which it shows, while what hides it fades towards the lens&apos;s middle and stays where it bends (Krüger, Schneider and Westermann 2006)</source>
        <translation>Una lente sobre el foco a través de la cual se ve, mientras lo que lo oculta se atenúa hacia el centro y queda donde se curva (Krüger, Schneider y Westermann 2006)</translation>
    </message>
    <message>
        <source>Lens keeps</source>
        <translation>La lente conserva</translation>
    </message>
    <message>
        <source>What stays within ClearView&apos;s lens of what hides the focus, beside its bends</source>
        <translation>Lo que queda en la lente de ClearView de lo que oculta el foco, además de sus curvas</translation>
    </message>
    <message>
        <source>Lens over</source>
        <translation>Lente sobre</translation>
    </message>
    <message>
        <source>What ClearView&apos;s lens lies over, as you see it</source>
        <translation>Sobre qué está la lente de ClearView, tal como se ve</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>Radius of ClearView&apos;s lens, as a share of the volume&apos;s longest side; its authors use 18.2</source>
        <translation>Radio de la lente de ClearView como parte del lado más largo del volumen; sus autores usan 18,2</translation>
    </message>
    <message>
        <source>Bends kept</source>
        <translation>Curvas conservadas</translation>
    </message>
    <message>
        <source>How much of the bends of what hides the focus stays within ClearView&apos;s lens; 0 keeps none</source>
        <translation>Cuánto queda en la lente de ClearView de las curvas de lo que oculta el foco; 0 no conserva nada</translation>
    </message>
    <message>
        <source>Rim of the lens</source>
        <translation>Borde de la lente</translation>
    </message>
    <message>
        <source>How thin the dark line around ClearView&apos;s lens is: more is thinner</source>
        <translation>Cuán fina es la línea oscura de la lente de ClearView: más es más fina</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Foco</translation>
    </message>
    <message>
        <source>The middle of the focus</source>
        <translation>El centro del foco</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Cruz</translation>
    </message>
    <message>
        <source>The crosshair: the lens follows what you point at</source>
        <translation>La cruz: la lente sigue lo que se señala</translation>
    </message>
    <message>
        <source>To the rim</source>
        <translation>Hacia el borde</translation>
    </message>
    <message>
        <source>The nearer to the lens&apos;s rim, the more of what hides the focus</source>
        <translation>Cuanto más cerca del borde de la lente, más de lo que oculta el foco</translation>
    </message>
    <message>
        <source>Evenly</source>
        <translation>Por igual</translation>
    </message>
    <message>
        <source>Nothing but the bends of what hides the focus</source>
        <translation>Solo las curvas de lo que oculta el foco</translation>
    </message>
    <message>
        <source>With depth</source>
        <translation>Con la profundidad</translation>
    </message>
    <message>
        <source>The more lies in front of the focus, the more of it</source>
        <translation>Cuanto más hay delante del foco, más de ello</translation>
    </message>
    <message>
        <source>Cone cutaway</source>
        <translation>Seccionado en cono</translation>
    </message>
    <message>
        <source>A funnel around everything in focus, which widens towards you at one angle: the deeper the focus lies, the wider the opening (Burns and Finkelstein 2008)</source>
        <translation>Un embudo en torno a todo lo enfocado que se ensancha hacia usted con un ángulo: cuanto más profundo el foco, más ancha la abertura (Burns y Finkelstein 2008)</translation>
    </message>
    <message>
        <source>Cone&apos;s angle</source>
        <translation>Ángulo del cono</translation>
    </message>
    <message>
        <source>Angle between the axis and the wall of the cone cutaway&apos;s cones: more opens wider</source>
        <translation>Ángulo entre el eje y la pared de los conos: más abre más</translation>
    </message>
    <message>
        <source>Context-preserving</source>
        <translation>Conserva el contexto</translation>
    </message>
    <message>
        <source>Nothing is cut away: what is flat, brightly lit and near to you fades, while edges stay, so that the inside shows; what is in focus stays as it is (Bruckner, Grimm, Kanitsar and Gröller 2006)</source>
        <translation>No se corta nada: lo plano, muy iluminado y cercano se atenúa y las aristas quedan, para que se vea el interior; lo enfocado queda tal cual (Bruckner, Grimm, Kanitsar y Gröller 2006)</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>How deep the context-preserving method looks into the volume; 0 fades nothing (κt)</source>
        <translation>Hasta qué profundidad mira el método que conserva el contexto; 0 no atenúa nada (κt)</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Nitidez</translation>
    </message>
    <message>
        <source>How sudden the context-preserving method changes from faded to shown along the line of sight: more looks like a cut (κs)</source>
        <translation>Cuán brusco es el paso de atenuado a mostrado a lo largo de la línea de visión: más parece un corte (κs)</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>Vista explosionada</translation>
    </message>
    <message>
        <source>What is around the focus is cut into parts, which move apart and out of your line of sight to it; what is in focus stays in its place (Bruckner and Gröller 2006)</source>
        <translation>El entorno del foco se corta en partes que se separan y salen de la línea de visión; lo enfocado queda en su lugar (Bruckner y Gröller 2006)</translation>
    </message>
    <message>
        <source>Explosion</source>
        <translation>Explosión</translation>
    </message>
    <message>
        <source>How far the parts of an exploded view are moved apart (its degree of explosion): at 0 all are in their places</source>
        <translation>Cuánto se separan las partes (grado de explosión): con 0 todas están en su lugar</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>How many planes through the middle of the focus, or of the volume without a focus, cut it into the parts of an exploded view</source>
        <translation>Cuántos planos por el centro del foco, o del volumen si no hay foco, lo cortan en las partes de una vista explosionada</translation>
    </message>
    <message>
        <source>Cut along</source>
        <translation>Cortar según</translation>
    </message>
    <message>
        <source>Whether the planes of an exploded view lie along the patient&apos;s axes or the view&apos;s</source>
        <translation>Si los planos siguen los ejes del paciente o los de la vista</translation>
    </message>
    <message>
        <source>Two halves</source>
        <translation>Dos mitades</translation>
    </message>
    <message>
        <source>One plane cuts the volume into left and right</source>
        <translation>Un plano corta el volumen en izquierda y derecha</translation>
    </message>
    <message>
        <source>Four quarters</source>
        <translation>Cuatro cuartos</translation>
    </message>
    <message>
        <source>Two planes: left and right, above and below</source>
        <translation>Dos planos: izquierda y derecha, arriba y abajo</translation>
    </message>
    <message>
        <source>Eight parts</source>
        <translation>Ocho partes</translation>
    </message>
    <message>
        <source>Three planes: left and right, above and below, front and back</source>
        <translation>Tres planos: izquierda y derecha, arriba y abajo, delante y detrás</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>El paciente</translation>
    </message>
    <message>
        <source>Planes along the patient&apos;s axes: left and right are the patient&apos;s</source>
        <translation>Planos según los ejes del paciente: izquierda y derecha son las del paciente</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>La vista</translation>
    </message>
    <message>
        <source>Planes along the picture&apos;s axes, which turn with the camera</source>
        <translation>Planos según los ejes de la imagen, que giran con la cámara</translation>
    </message>
    <message>
        <source>Focal region</source>
        <translation>Región focal</translation>
    </message>
    <message>
        <source>A region around the focus shows as it is; around it only the edges of what is there stay, the fainter the farther away; what is in focus stays as it is (Zhou, Hinz and Tönnies 2002)</source>
        <translation>Una región en torno al foco se ve tal cual; alrededor solo quedan las aristas, más tenues cuanto más lejos; lo enfocado queda tal cual (Zhou, Hinz y Tönnies 2002)</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Shape of the focal region, around the focus, or around the middle of the volume without a focus</source>
        <translation>Forma de la región focal, en torno al foco o, sin foco, al centro del volumen</translation>
    </message>
    <message>
        <source>Size of region</source>
        <translation>Tamaño de la región</translation>
    </message>
    <message>
        <source>Radius of the focal region&apos;s sphere, half the side of its box, or its distance from the focus</source>
        <translation>Radio de la esfera, mitad del lado de la caja, o distancia al foco</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Caída</translation>
    </message>
    <message>
        <source>How far outside of the focal region edges are half as strong as at its border: more shows more of what is around it</source>
        <translation>A qué distancia de la región focal las aristas tienen la mitad de fuerza que en su borde: más muestra más del entorno</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>A ball around the middle of the focus</source>
        <translation>Una bola en torno al centro del foco</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>A cube along the patient&apos;s axes, around the middle of the focus</source>
        <translation>Un cubo según los ejes del paciente en torno al centro del foco</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Everything that lies near the focus, whatever its shape</source>
        <translation>Todo lo que está cerca del foco, sea cual sea su forma</translation>
    </message>
    <message>
        <source>Importance-driven</source>
        <translation>Según importancia</translation>
    </message>
    <message>
        <source>What hides the focus gives way to it because the focus is more important: it is removed, or stays faint (Viola, Kanitsar and Gröller 2004)</source>
        <translation>Lo que oculta el foco cede porque el foco es más importante: se quita o queda tenue (Viola, Kanitsar y Gröller 2004)</translation>
    </message>
    <message>
        <source>What hides the focus</source>
        <translation>Lo que oculta el foco</translation>
    </message>
    <message>
        <source>What the importance-driven method does with what hides the focus</source>
        <translation>Qué hace el método según importancia con lo que oculta el foco</translation>
    </message>
    <message>
        <source>Widening</source>
        <translation>Ensanche</translation>
    </message>
    <message>
        <source>Angle at which the importance-driven opening widens from the focus&apos;s outline towards the eye</source>
        <translation>Ángulo con que la abertura se ensancha desde el contorno del foco hacia el ojo</translation>
    </message>
    <message>
        <source>Opacity left</source>
        <translation>Opacidad restante</translation>
    </message>
    <message>
        <source>Factor of the opacity of what hides the focus, where the importance-driven method keeps it faint; 0 removes it</source>
        <translation>Factor de opacidad de lo que oculta el foco, donde el método lo deja tenue; 0 lo quita</translation>
    </message>
    <message>
        <source>Faint how</source>
        <translation>Cómo tenue</translation>
    </message>
    <message>
        <source>How what hides the focus is made faint</source>
        <translation>Cómo se atenúa lo que oculta el foco</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Quitado</translation>
    </message>
    <message>
        <source>What hides the focus is removed, in a cone that widens from the focus&apos;s outline towards you (maximum importance projection)</source>
        <translation>Lo que oculta el foco se quita, en un cono que se ensancha desde su contorno hacia usted (maximum importance projection)</translation>
    </message>
    <message>
        <source>Faint</source>
        <translation>Tenue</translation>
    </message>
    <message>
        <source>What hides the focus stays, but faint (average importance compositing)</source>
        <translation>Lo que oculta el foco queda, pero tenue (average importance compositing)</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>Translúcido</translation>
    </message>
    <message>
        <source>Less opaque, in its own colours</source>
        <translation>Menos opaco, en sus propios colores</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Less opaque, and grey, so that the colours are the focus&apos;s alone</source>
        <translation>Menos opaco y gris, para que solo el foco tenga color</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Punteado</translation>
    </message>
    <message>
        <source>As it is on a few pixels in an even pattern, and left out on the others</source>
        <translation>Tal cual en unos pocos píxeles en un patrón regular, y omitido en los demás</translation>
    </message>
    <message>
        <source>Maximum intensity (MIP)</source>
        <translation>Intensidad máxima (MIP)</translation>
    </message>
    <message>
        <source>The body shows by the greatest value on each line of sight, as in a maximum intensity projection, and the focus stands in it; what lies before the opening does not count (Wallis, Miller, Lerner and Kleerup 1989)</source>
        <translation>El cuerpo se ve por el valor máximo de cada línea de visión, como en una proyección de intensidad máxima, con el foco dentro; lo que queda delante de la abertura no cuenta (Wallis, Miller, Lerner y Kleerup 1989)</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>How thick a layer the maximum intensity projection shows of the greatest value: more is more opaque</source>
        <translation>Qué grosor de capa del valor máximo muestra la proyección de intensidad máxima: más es más opaco</translation>
    </message>
    <message>
        <source>Peeling</source>
        <translation>Pelado</translation>
    </message>
    <message>
        <source>A layer in front of the focus is cut in two, and its halves are rolled aside like a peel; what is in focus stays in its place (McGuffin et al. 2003; Correa et al. 2006)</source>
        <translation>Una capa delante del foco se corta en dos y sus mitades se enrollan a los lados como una piel; lo enfocado queda en su lugar (McGuffin et al. 2003; Correa et al. 2006)</translation>
    </message>
    <message>
        <source>Peeled</source>
        <translation>Pelado</translation>
    </message>
    <message>
        <source>How far the layer in front of the focus is peeled away: at 0 it lies in its place, at 1 none of it lies in front of the focus</source>
        <translation>Cuánto se ha pelado la capa delante del foco: con 0 está en su lugar, con 1 nada de ella queda delante</translation>
    </message>
    <message>
        <source>Peel off</source>
        <translation>Pelar desde</translation>
    </message>
    <message>
        <source>Which side of the patient the layer is peeled off</source>
        <translation>De qué lado del paciente se pela la capa</translation>
    </message>
    <message>
        <source>Cut turned by</source>
        <translation>Corte girado</translation>
    </message>
    <message>
        <source>Turns the cut through the layer: at 0 it runs from head to foot, or from front to back where the layer is peeled off above or below</source>
        <translation>Gira el corte de la capa: con 0 va de cabeza a pies, o de delante atrás si se pela por arriba o por abajo</translation>
    </message>
    <message>
        <source>Layer down to</source>
        <translation>Capa hasta</translation>
    </message>
    <message>
        <source>How deep the layer reaches: at 0 it ends just in front of the focus, at 1 just behind it</source>
        <translation>Hasta dónde llega la capa: con 0 acaba justo delante del foco, con 1 justo detrás</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollo</translation>
    </message>
    <message>
        <source>Radius of the hollow in the roll: less rolls the layer up more tightly</source>
        <translation>Radio del hueco del rollo: menos enrolla la capa más apretada</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>How far the opened window reaches beyond the focus on all its sides</source>
        <translation>Cuánto sobresale la ventana abierta del foco por todos lados</translation>
    </message>
    <message>
        <source>The front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>The patient&apos;s anterior side</source>
        <translation>El lado anterior del paciente</translation>
    </message>
    <message>
        <source>The back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>The patient&apos;s posterior side</source>
        <translation>El lado posterior del paciente</translation>
    </message>
    <message>
        <source>The left</source>
        <translation>La izquierda</translation>
    </message>
    <message>
        <source>The patient&apos;s left side</source>
        <translation>El lado izquierdo del paciente</translation>
    </message>
    <message>
        <source>The right</source>
        <translation>La derecha</translation>
    </message>
    <message>
        <source>The patient&apos;s right side</source>
        <translation>El lado derecho del paciente</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>The patient&apos;s superior side</source>
        <translation>El lado superior del paciente</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Abajo</translation>
    </message>
    <message>
        <source>The patient&apos;s inferior side</source>
        <translation>El lado inferior del paciente</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Esculpido</translation>
    </message>
    <message>
        <source>Nothing opens by itself: you carve the volume with a ball, a box or a saw until the focus shows (Wang and Kaufman 1995)</source>
        <translation>Nada se abre por sí solo: se talla el volumen con una bola, una caja o una sierra hasta ver el foco (Wang y Kaufman 1995)</translation>
    </message>
    <message>
        <source>Ghosted selection</source>
        <translation>Selección fantasma</translation>
    </message>
    <message>
        <source>Nothing is cut away: in front of the focus, and in the opening around it, what is flat gives way and edges stay, like a ghost of it; what is in focus stays as it is (Bruckner and Gröller 2005)</source>
        <translation>No se corta nada: delante del foco y en la abertura en torno a él, lo plano cede y las aristas quedan como un fantasma; lo enfocado queda tal cual (Bruckner y Gröller 2005)</translation>
    </message>
    <message>
        <source>Ghosting</source>
        <translation>Efecto fantasma</translation>
    </message>
    <message>
        <source>How much of what is flat in front of the selection gives way; 0 fades nothing</source>
        <translation>Cuánto cede lo plano delante de la selección; 0 no atenúa nada</translation>
    </message>
    <message>
        <source>Edges from</source>
        <translation>Aristas desde</translation>
    </message>
    <message>
        <source>Gradient of which half stays in front of the selection, as a share of the steepest that the volume can have: less keeps fainter edges</source>
        <translation>Gradiente del que la mitad queda delante de la selección, como parte del más fuerte posible en el volumen: menos conserva aristas más débiles</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contornos</translation>
    </message>
    <message>
        <source>How much edges that face you give way, too, so that outlines stay in front of the selection</source>
        <translation>Cuánto ceden también las aristas de frente, para que queden los contornos delante de la selección</translation>
    </message>
    <message>
        <source>Walls of slices</source>
        <translation>Paredes de cortes</translation>
    </message>
    <message>
        <source>The adaptive cutaway with the slices at the crosshair as walls: behind the volume, or inside the opening (Tory and Swindells 2003)</source>
        <translation>El seccionado adaptativo con los cortes de la cruz como paredes: detrás del volumen o dentro de la abertura (Tory y Swindells 2003)</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Paredes</translation>
    </message>
    <message>
        <source>Where the walls of slices stand</source>
        <translation>Dónde están las paredes de cortes</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Whether the axial slice at the crosshair is a wall</source>
        <translation>Si el corte axial en la cruz es una pared</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Whether the sagittal slice at the crosshair is a wall</source>
        <translation>Si el corte sagital en la cruz es una pared</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Whether the coronal slice at the crosshair is a wall</source>
        <translation>Si el corte coronal en la cruz es una pared</translation>
    </message>
    <message>
        <source>Whether the labels&apos; outlines are drawn on the walls</source>
        <translation>Si los contornos de las etiquetas se dibujan en las paredes</translation>
    </message>
    <message>
        <source>Around the volume</source>
        <translation>Alrededor del volumen</translation>
    </message>
    <message>
        <source>Behind the volume, like the walls of a room</source>
        <translation>Detrás del volumen, como las paredes de una habitación</translation>
    </message>
    <message>
        <source>Inside the opening</source>
        <translation>Dentro de la abertura</translation>
    </message>
    <message>
        <source>Where the slices lie, in the space that the opening removed; before the focus there is none</source>
        <translation>Donde están los cortes, en el espacio que quitó la abertura; delante del foco no hay ninguna</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>píxeles</translation>
    </message>
    <message>
        <source>millimetres at the focus</source>
        <translation>milímetros en el foco</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Bola</translation>
    </message>
    <message>
        <source>A ball, where the mouse goes</source>
        <translation>Una bola por donde va el ratón</translation>
    </message>
    <message>
        <source>A box that faces you, where the mouse goes</source>
        <translation>Una caja de frente a usted por donde va el ratón</translation>
    </message>
    <message>
        <source>Saw</source>
        <translation>Sierra</translation>
    </message>
    <message>
        <source>A blade along the stroke, away from you; a stroke that comes back to its start takes out what it encloses</source>
        <translation>Una hoja a lo largo del trazo, alejándose de usted; un trazo que vuelve a su inicio saca lo que encierra</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>A plane through the stroke that removes what lies to the right of it, and that you bend by dragging</source>
        <translation>Un plano por el trazo que quita lo que queda a su derecha y que se curva arrastrando</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Brings back what the opening removed</source>
        <translation>Devuelve lo que quitó la abertura</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Opens further, away from the eye</source>
        <translation>Abre más, alejándose del ojo</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Atenuar</translation>
    </message>
    <message>
        <source>Shows less of the context&apos;s edges over the focus</source>
        <translation>Muestra menos aristas del contexto sobre el foco</translation>
    </message>
    <message>
        <source>Strengthen</source>
        <translation>Reforzar</translation>
    </message>
    <message>
        <source>Shows more of the context&apos;s edges over the focus</source>
        <translation>Muestra más aristas del contexto sobre el foco</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexto</translation>
    </message>
    <message>
        <source>Cut away where it hides the focus</source>
        <translation>Se corta donde oculta el foco</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Oculta</translation>
    </message>
    <message>
        <source>Left out of 3-D pictures; slices show its voxels</source>
        <translation>Omitida en imágenes 3D; los cortes muestran sus vóxeles</translation>
    </message>
    <message>
        <source>Protected</source>
        <translation>Protegida</translation>
    </message>
    <message>
        <source>Never cut away, even where it hides the focus</source>
        <translation>Nunca se corta, aunque oculte el foco</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>What is connected to the click by values near its own</source>
        <translation>Lo conectado al clic por valores próximos al suyo</translation>
    </message>
    <message>
        <source>Tissues</source>
        <translation>Tejidos</translation>
    </message>
    <message>
        <source>What belongs to the clicked tissue more than to any other of the volume</source>
        <translation>Lo que pertenece al tejido del clic más que a cualquier otro del volumen</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Recto</translation>
    </message>
    <message>
        <source>Straight lines between voxels: coarse scans show terraces</source>
        <translation>Líneas rectas entre vóxeles: adquisiciones gruesas muestran terrazas</translation>
    </message>
    <message>
        <source>Curved</source>
        <translation>Curvo</translation>
    </message>
    <message>
        <source>Smooth curves through every voxel, its noise as well: takes more memory and time</source>
        <translation>Curvas suaves por cada vóxel, también por su ruido: requiere más memoria y tiempo</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>Smooth curves near the voxels: fewer terraces and less noise, but softer detail</source>
        <translation>Curvas suaves cerca de los vóxeles: menos terrazas y ruido, pero detalle más blando</translation>
    </message>
    <message>
        <source>Smoothed more</source>
        <translation>Más suavizado</translation>
    </message>
    <message>
        <source>Smooth curves near means over five voxels: no terraces in coarse scans, but fine detail is lost</source>
        <translation>Curvas suaves cerca de medias de cinco vóxeles: sin terrazas, pero se pierde detalle fino</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Smoothed where voxels are coarse and not too many, else straight</source>
        <translation>Suavizado donde los vóxeles son gruesos y no demasiados; si no, recto</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Un color</translation>
    </message>
    <message>
        <source>The background&apos;s colour everywhere</source>
        <translation>El color del fondo en todas partes</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>From the background&apos;s colour at the bottom to another at the top</source>
        <translation>Del color del fondo abajo a otro arriba</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exacto</translation>
    </message>
    <message>
        <source>As the labels have it, with the steps of their voxels</source>
        <translation>Como la tienen las etiquetas, con los escalones de sus vóxeles</translation>
    </message>
    <message>
        <source>Lightly smoothed</source>
        <translation>Ligeramente suavizado</translation>
    </message>
    <message>
        <source>Without the steps of single voxels</source>
        <translation>Sin los escalones de cada vóxel</translation>
    </message>
    <message>
        <source>Strongly smoothed</source>
        <translation>Muy suavizado</translation>
    </message>
    <message>
        <source>Without terraces of several voxels</source>
        <translation>Sin terrazas de varios vóxeles</translation>
    </message>
    <message>
        <source>One ray a pixel</source>
        <translation>Un rayo por píxel</translation>
    </message>
    <message>
        <source>Edges show the steps of the pixels</source>
        <translation>Las aristas muestran los escalones de los píxeles</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Several rays for each pixel that an edge runs through</source>
        <translation>Varios rayos por cada píxel que cruza una arista</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspectiva</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>ortográfica</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>borrador</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>high</source>
        <translation>alta</translation>
    </message>
    <message>
        <source>Open the context around the focus</source>
        <translation>Abrir el contexto en torno al foco</translation>
    </message>
    <message>
        <source>Whether the context is cut away around the focus</source>
        <translation>Si el contexto en torno al foco se corta</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Abertura</translation>
    </message>
    <message>
        <source>How far the opening reaches beyond the focus (w_open)</source>
        <translation>Cuánto se extiende la abertura más allá del foco (w_open)</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Borde</translation>
    </message>
    <message>
        <source>Width of the line around the opening (w_border)</source>
        <translation>Ancho de la línea en torno a la abertura (w_border)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Unit of both widths: pixels of the screen, or mm at the depth of the focus, which keep the opening still while zooming</source>
        <translation>Unidad de ambos anchos: píxeles de la pantalla, o mm a la profundidad del foco, que mantienen fija la abertura al hacer zoom</translation>
    </message>
    <message>
        <source>Border colour</source>
        <translation>Color del borde</translation>
    </message>
    <message>
        <source>Colour of the line around the opening</source>
        <translation>Color de la línea en torno a la abertura</translation>
    </message>
    <message>
        <source>Axis offset</source>
        <translation>Desvío del eje</translation>
    </message>
    <message>
        <source>Angle between the opening&apos;s axis and the line of sight, so that its depth shows</source>
        <translation>Ángulo entre el eje de la abertura y la línea de visión, para que se vea su profundidad</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>To which side of the picture the opening&apos;s axis leans: 0 is the right, 90 the top</source>
        <translation>Hacia qué lado de la imagen se inclina el eje de la abertura: 0 es la derecha, 90 arriba</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>How strongly the edges of the removed context are drawn over the focus; 0 draws none</source>
        <translation>Con qué fuerza se dibujan sobre el foco las aristas del contexto quitado; 0 no dibuja ninguna</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Curvatura</translation>
    </message>
    <message>
        <source>How much bends of the context&apos;s surface count as edges: eyes, nose, ears</source>
        <translation>Cuánto cuentan como aristas las curvas de la superficie del contexto: ojos, nariz, orejas</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Silueta</translation>
    </message>
    <message>
        <source>How much the context&apos;s outlines, where its surface is seen edge-on, count as edges</source>
        <translation>Cuánto cuentan como aristas los contornos del contexto, donde su superficie se ve de canto</translation>
    </message>
    <message>
        <source>Illumination</source>
        <translation>Iluminación</translation>
    </message>
    <message>
        <source>How much the light on the context&apos;s surface shades its edges; 0 draws them flat</source>
        <translation>Cuánto sombrea las aristas la luz sobre la superficie del contexto; 0 las dibuja planas</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Color propio</translation>
    </message>
    <message>
        <source>How much the edges take the context&apos;s own colour</source>
        <translation>Cuánto toman las aristas el color propio del contexto</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturación</translation>
    </message>
    <message>
        <source>How saturated the context&apos;s own colour is in its edges</source>
        <translation>Cuán saturado es el color propio del contexto en sus aristas</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Proporción</translation>
    </message>
    <message>
        <source>How much of the focus the edges may cover at most: the strongest stay; 1 keeps all</source>
        <translation>Cuánto del foco pueden cubrir las aristas como mucho: quedan las más fuertes; 1 las conserva todas</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Colour of the context&apos;s edges</source>
        <translation>Color de las aristas del contexto</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Sombreado</translation>
    </message>
    <message>
        <source>Whether surfaces are lit by the gradient of the values</source>
        <translation>Si las superficies se iluminan según el gradiente de los valores</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Ambiente</translation>
    </message>
    <message>
        <source>Light from all sides</source>
        <translation>Luz de todos los lados</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Difusa</translation>
    </message>
    <message>
        <source>Light that a matt surface scatters</source>
        <translation>Luz que dispersa una superficie mate</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Especular</translation>
    </message>
    <message>
        <source>Strength of the highlights</source>
        <translation>Intensidad de los brillos</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>Exponent of the highlights: a larger one makes them smaller and sharper</source>
        <translation>Exponente de los brillos: uno mayor los hace más pequeños y nítidos</translation>
    </message>
    <message>
        <source>Light azimuth</source>
        <translation>Acimut de la luz</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is behind the viewer, 90 the right of the picture</source>
        <translation>De dónde viene la luz: 0 es detrás del observador, 90 la derecha de la imagen</translation>
    </message>
    <message>
        <source>Light elevation</source>
        <translation>Elevación de la luz</translation>
    </message>
    <message>
        <source>How high the light stands: 90 is the top of the picture, -90 the bottom</source>
        <translation>A qué altura está la luz: 90 es arriba de la imagen, -90 abajo</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Oclusión</translation>
    </message>
    <message>
        <source>How dark hollows are, which what is around them hides from the light from all sides; 0 leaves them as bright as the rest and costs nothing</source>
        <translation>Cuán oscuros son los huecos a los que el entorno quita la luz de todos lados; 0 los deja tan claros como el resto y no cuesta nada</translation>
    </message>
    <message>
        <source>Soft shadow</source>
        <translation>Sombra suave</translation>
    </message>
    <message>
        <source>How dark the shadows are that the volume, as it is cut open, casts on itself; 0 casts none and costs nothing</source>
        <translation>Cuán oscuras son las sombras que el volumen abierto arroja sobre sí mismo; 0 no arroja ninguna y no cuesta nada</translation>
    </message>
    <message>
        <source>Colour of a focus of values; labels have colours of their own</source>
        <translation>Color de un foco por valores; las etiquetas tienen los suyos</translation>
    </message>
    <message>
        <source>Extinction</source>
        <translation>Extinción</translation>
    </message>
    <message>
        <source>Extinction coefficient of the focus</source>
        <translation>Coeficiente de extinción del foco</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>Smallest island</source>
        <translation>Isla mínima</translation>
    </message>
    <message>
        <source>Volume below which an island of a focus of values is left out</source>
        <translation>Volumen por debajo del cual se omite una isla de un foco por valores</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Moves the whole transfer function along the values</source>
        <translation>Desplaza toda la función de transferencia a lo largo de los valores</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Colour behind the volume; of a gradient, at the bottom</source>
        <translation>Color tras el volumen; de un degradado, el de abajo</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Tipo de fondo</translation>
    </message>
    <message>
        <source>Whether one colour is behind the volume, or a gradient of two</source>
        <translation>Si tras el volumen hay un color o un degradado de dos</translation>
    </message>
    <message>
        <source>Top of the gradient</source>
        <translation>Arriba del degradado</translation>
    </message>
    <message>
        <source>Colour of a gradient behind the volume at the top</source>
        <translation>Color de arriba de un degradado tras el volumen</translation>
    </message>
    <message>
        <source>Hide the table</source>
        <translation>Ocultar la mesa</translation>
    </message>
    <message>
        <source>Whether 3-D pictures of a CT leave out the scanner&apos;s table, head rest and cushions</source>
        <translation>Si las imágenes 3D de una TC omiten la mesa del escáner, el reposacabezas y los cojines</translation>
    </message>
    <message>
        <source>Between voxels</source>
        <translation>Entre vóxeles</translation>
    </message>
    <message>
        <source>How 3-D pictures fill in the values between the voxels</source>
        <translation>Cómo completan las imágenes 3D los valores entre vóxeles</translation>
    </message>
    <message>
        <source>Label surfaces</source>
        <translation>Superficies</translation>
    </message>
    <message>
        <source>How far 3-D pictures smooth the surface of labels in focus: it stays within the voxels that it passes through, and keeps its volume</source>
        <translation>Cuánto suavizan las imágenes 3D la superficie de las etiquetas del foco: queda dentro de los vóxeles que atraviesa y conserva su volumen</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Bordes</translation>
    </message>
    <message>
        <source>Whether 3-D pictures at rest smooth outlines and the rims of what is cut</source>
        <translation>Si las imágenes 3D en reposo suavizan contornos y bordes de corte</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>What the stroke does</source>
        <translation>Qué hace el trazo</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radio del pincel</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>Share of the radius over which the effect fades out</source>
        <translation>Parte del radio en la que se desvanece el efecto</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>How far along the ray Restore and Open move its start at most</source>
        <translation>Cuánto desplazan como máximo Restaurar y Abrir el inicio del rayo</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>How much of the context&apos;s edges Fade takes or Strengthen adds</source>
        <translation>Cuánto quita Atenuar o añade Reforzar de las aristas del contexto</translation>
    </message>
    <message>
        <source>To the surface</source>
        <translation>Hasta la superficie</translation>
    </message>
    <message>
        <source>Whether Restore reaches to the context&apos;s first surface, however deep that lies</source>
        <translation>Si Restaurar llega hasta la primera superficie del contexto, por profunda que esté</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>Puede cubrir el foco</translation>
    </message>
    <message>
        <source>Whether restored context may hide the focus</source>
        <translation>Si el contexto restaurado puede ocultar el foco</translation>
    </message>
    <message>
        <source>Whether the stroke is kept without effect</source>
        <translation>Si el trazo se guarda sin efecto</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>View in which it shows: 0 for C1, 1 for C2, -1 for both</source>
        <translation>Vista en que se ve: 0 para C1, 1 para C2, -1 para ambas</translation>
    </message>
    <message>
        <source>Edges and border</source>
        <translation>Aristas y borde</translation>
    </message>
    <message>
        <source>Cut alone</source>
        <translation>Solo el corte</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>Aristas del contexto</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Estándar</translation>
    </message>
    <message>
        <source>A little gloss</source>
        <translation>Un poco de brillo</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>Mate</translation>
    </message>
    <message>
        <source>Without highlights, as plaster</source>
        <translation>Sin brillos, como yeso</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Hueso</translation>
    </message>
    <message>
        <source>Soft shades and a wide sheen</source>
        <translation>Sombras suaves y un lustre amplio</translation>
    </message>
    <message>
        <source>Wet</source>
        <translation>Húmedo</translation>
    </message>
    <message>
        <source>Small and strong highlights, as moist tissue in an operation</source>
        <translation>Brillos pequeños y fuertes, como tejido húmedo en una operación</translation>
    </message>
    <message>
        <source>Technical</source>
        <translation>Técnico</translation>
    </message>
    <message>
        <source>Even light that keeps colours to be told apart</source>
        <translation>Luz uniforme que mantiene distinguibles los colores</translation>
    </message>
    <message>
        <source>the point lies outside of the volume</source>
        <translation>el punto está fuera del volumen</translation>
    </message>
    <message>
        <source>the point lies in air, where there is no structure</source>
        <translation>el punto está en el aire, donde no hay ninguna estructura</translation>
    </message>
    <message>
        <source>no region can be grown from the point</source>
        <translation>no puede crecer ninguna región desde el punto</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
    <message>
        <source>Torso</source>
        <translation>Torso</translation>
    </message>
    <message>
        <source>CT angio</source>
        <translation>TC angio</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>TC hueso</translation>
    </message>
    <message>
        <source>CT lung</source>
        <translation>TC pulmón</translation>
    </message>
    <message>
        <source>CT plain</source>
        <translation>TC simple</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>TC piel</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>TC partes blandas</translation>
    </message>
    <message>
        <source>MR angio</source>
        <translation>RM angio</translation>
    </message>
    <message>
        <source>MR bright</source>
        <translation>RM brillante</translation>
    </message>
    <message>
        <source>MR T1</source>
        <translation>RM T1</translation>
    </message>
    <message>
        <source>MR T2</source>
        <translation>RM T2</translation>
    </message>
    <message>
        <source>MR</source>
        <translation>RM</translation>
    </message>
    <message>
        <source>PET</source>
        <translation>PET</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ecografía</translation>
    </message>
    <message>
        <source>making the phantom</source>
        <translation>creando el fantoma</translation>
    </message>
    <message>
        <source>unpacking</source>
        <translation>desempaquetando</translation>
    </message>
    <message>
        <source>comparing contents</source>
        <translation>comparando contenidos</translation>
    </message>
    <message>
        <source>the only one whose geometry is plausible</source>
        <translation>la única de geometría plausible</translation>
    </message>
    <message>
        <source>the only one that is no overview, capture or reformat</source>
        <translation>la única que no es localizador, captura ni reformateo</translation>
    </message>
    <message>
        <source>the only %1</source>
        <translation>la única de su clase (%1)</translation>
    </message>
    <message>
        <source>the thinnest %1, %2</source>
        <translation>la más fina de su clase (%1), %2</translation>
    </message>
    <message>
        <source>of the thinnest ones, %1, the one of most voxels</source>
        <translation>de las más finas, %1, la de más vóxeles</translation>
    </message>
    <message>
        <source>the %1 of most voxels</source>
        <translation>la de más vóxeles (%1)</translation>
    </message>
    <message>
        <source>of equal ones the first by its number, %1</source>
        <translation>de las iguales, la primera por su número, %1</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volumen</translation>
    </message>
    <message>
        <source>stack of slices</source>
        <translation>pila de cortes</translation>
    </message>
    <message>
        <source>image</source>
        <translation>imagen</translation>
    </message>
    <message>
        <source>reading headers</source>
        <translation>leyendo cabeceras</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>leyendo cortes</translation>
    </message>
    <message>
        <source>filling contours</source>
        <translation>rellenando contornos</translation>
    </message>
    <message>
        <source>reading segments</source>
        <translation>leyendo segmentos</translation>
    </message>
    <message>
        <source>writing segments</source>
        <translation>escribiendo segmentos</translation>
    </message>
    <message>
        <source>reading voxels</source>
        <translation>leyendo vóxeles</translation>
    </message>
    <message>
        <source>growing the region</source>
        <translation>haciendo crecer la región</translation>
    </message>
    <message>
        <source>looking for moved data</source>
        <translation>buscando datos movidos</translation>
    </message>
    <message>
        <source>finding the focus</source>
        <translation>buscando el foco</translation>
    </message>
    <message>
        <source>extracting the surface</source>
        <translation>extrayendo la superficie</translation>
    </message>
    <message>
        <source>smoothing the surface</source>
        <translation>suavizando la superficie</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>Editando la etiqueta</translation>
    </message>
    <message>
        <source>acquired volume</source>
        <translation>volumen adquirido</translation>
    </message>
    <message>
        <source>acquired stack of slices</source>
        <translation>pila de cortes adquirida</translation>
    </message>
    <message>
        <source>acquired image</source>
        <translation>imagen adquirida</translation>
    </message>
    <message>
        <source>volume that is no overview, capture or reformat</source>
        <translation>volumen que no es localizador, captura ni reformateo</translation>
    </message>
    <message>
        <source>stack of slices that is no overview, capture or reformat</source>
        <translation>pila de cortes que no es localizador, captura ni reformateo</translation>
    </message>
    <message>
        <source>image that is no overview, capture or reformat</source>
        <translation>imagen que no es localizador, captura ni reformateo</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Como el escritorio</translation>
    </message>
    <message>
        <source>How deep the focus lies; below 0 prefers views with little in front of it.
vd1 = mean depth of the focus&apos;s pixels / diameter of the model&apos;s sphere</source>
        <translation>Cuán profundo está el foco; por debajo de 0 prefiere vistas con poco delante.
vd1 = profundidad media de los píxeles del foco / diámetro de la esfera del modelo</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>How large the focus is in the picture.
vd2 = pixels of the focus / pixels of the picture</source>
        <translation>Cuán grande es el foco en la imagen.
vd2 = píxeles del foco / píxeles de la imagen</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>Centrado</translation>
    </message>
    <message>
        <source>How near to the middle of the picture it is.
vd3 = 1 − distance of its centroid from the middle / distance of a corner</source>
        <translation>Cuán cerca está del centro de la imagen.
vd3 = 1 − distancia de su centroide al centro / distancia de una esquina</translation>
    </message>
    <message>
        <source>Cut ends</source>
        <translation>Extremos cortados</translation>
    </message>
    <message>
        <source>Below 0 avoids looking at the focus through a face where the scan cuts the body off.
Share of the focus&apos;s pixels whose rays enter the volume inside the body</source>
        <translation>Por debajo de 0 evita mirar el foco a través de una cara donde la adquisición corta el cuerpo.
Parte de los píxeles del foco cuyos rayos entran en el volumen dentro del cuerpo</translation>
    </message>
    <message>
        <source>Evenness</source>
        <translation>Uniformidad</translation>
    </message>
    <message>
        <source>How much of its surface is seen.
Viewpoint entropy −Σ p log p of the seen surface points, over its maximum (Bordoloi, Shen 2005)</source>
        <translation>Cuánto se ve de su superficie.
Entropía del punto de vista −Σ p log p de los puntos vistos, sobre su máximo (Bordoloi, Shen 2005)</translation>
    </message>
    <message>
        <source>Typical</source>
        <translation>Típica</translation>
    </message>
    <message>
        <source>How typical the view is of all views.
1 − Σ p(o|v) log(p(o|v) / p(o)) over its maximum (Viola et al. 2006)</source>
        <translation>Cuán típica es la vista entre todas.
1 − Σ p(o|v) log(p(o|v) / p(o)) sobre su máximo (Viola et al. 2006)</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Estable</translation>
    </message>
    <message>
        <source>How little changes when the camera moves a bit.
1 − Jensen–Shannon divergence to the eight nearest views</source>
        <translation>Cuán poco cambia cuando la cámara se mueve un poco.
1 − divergencia de Jensen-Shannon con las ocho vistas más próximas</translation>
    </message>
    <message>
        <source>Standard view</source>
        <translation>Vista estándar</translation>
    </message>
    <message>
        <source>How near the view is to anterior, left, superior …: a little decides between equally good views.
Cosine of the angle to the nearest of the six</source>
        <translation>Cuán cerca está la vista de anterior, izquierda, superior …: un poco decide entre vistas igual de buenas.
Coseno del ángulo con la más próxima de las seis</translation>
    </message>
    <message>
        <source>Not through cut ends</source>
        <translation>No a través de extremos cortados</translation>
    </message>
    <message>
        <source>No view within 45° of an end of the scan where the body goes on, while another one shows at least two thirds as much of the focus</source>
        <translation>Ninguna vista a menos de 45° de un extremo de la adquisición donde el cuerpo continúa, mientras otra muestre al menos dos tercios del foco</translation>
    </message>
    <message>
        <source>From around before from above</source>
        <translation>De alrededor antes que de arriba</translation>
    </message>
    <message>
        <source>From the front, from behind, the left or the right rather than from above or below, where both show about as much</source>
        <translation>De frente, de atrás, de la izquierda o la derecha antes que de arriba o abajo, si ambas muestran más o menos lo mismo</translation>
    </message>
    <message>
        <source>Thin stacks from the front</source>
        <translation>Pilas finas de frente</translation>
    </message>
    <message>
        <source>A stack of a few slices, or one much thinner than wide, is seen from the side from which its slices are shown, not edge-on</source>
        <translation>Una pila de pocos cortes, o mucho más fina que ancha, se mira desde el lado en que se muestran sus cortes, no de canto</translation>
    </message>
    <message>
        <source>From the near side</source>
        <translation>Desde el lado cercano</translation>
    </message>
    <message>
        <source>Language (at the next start)</source>
        <translation>Idioma (al próximo inicio)</translation>
    </message>
    <message>
        <source>Language of the window&apos;s texts and numbers; it changes when Fenestra starts again</source>
        <translation>Idioma de los textos y números de la ventana; cambia cuando Fenestra se inicia de nuevo</translation>
    </message>
    <message>
        <source>Usual side</source>
        <translation>Lado habitual</translation>
    </message>
    <message>
        <source>How usual the view is: from the front rather than from the side, from behind, from above or below</source>
        <translation>Cuán habitual es la vista: de frente antes que de lado, de atrás, de arriba o de abajo</translation>
    </message>
    <message>
        <source>Last view</source>
        <translation>Última vista</translation>
    </message>
    <message>
        <source>How near the view is to the present one, so that it does not jump</source>
        <translation>Cuán cerca está la vista de la actual, para que no salte</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>How well the view shows the structure&apos;s shape around the point: onto what is flat, across what is long</source>
        <translation>Cuán bien muestra la vista la forma de la estructura en torno al punto: de frente a lo plano, de través a lo largo</translation>
    </message>
    <message>
        <source>Unhidden</source>
        <translation>Sin ocultar</translation>
    </message>
    <message>
        <source>How little hides the structure around the point, before anything is cut away</source>
        <translation>Cuán poco oculta la estructura en torno al punto, antes de cortar nada</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>Convención neurológica</translation>
    </message>
    <message>
        <source>Axial and coronal slices show the patient&apos;s left on the left; otherwise it is on the right, as radiologists have it</source>
        <translation>Los cortes axiales y coronales muestran la izquierda del paciente a la izquierda; si no, a la derecha, como en radiología</translation>
    </message>
    <message>
        <source>Objects of archives, at most</source>
        <translation>Objetos de archivos, como máximo</translation>
    </message>
    <message>
        <source>Disk space for what was retrieved from archive servers: the series used longest ago go first</source>
        <translation>Espacio en disco para lo recuperado de servidores de archivo: las series que llevan más tiempo sin usarse se van primero</translation>
    </message>
    <message>
        <source>GB</source>
        <translation>GB</translation>
    </message>
    <message>
        <source>de-identifying</source>
        <translation>anonimizando</translation>
    </message>
    <message>
        <source>listing files</source>
        <translation>listando archivos</translation>
    </message>
    <message>
        <source>looking for faces</source>
        <translation>buscando rostros</translation>
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
        <translation>Media</translation>
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
        <translation>Enfocar %1</translation>
    </message>
    <message>
        <source>Take %1 out of the focus</source>
        <translation>Quitar %1 del foco</translation>
    </message>
    <message>
        <source>Add %1 to the focus</source>
        <translation>Añadir %1 al foco</translation>
    </message>
    <message>
        <source>Grow a region from here</source>
        <translation>Hacer crecer una región desde aquí</translation>
    </message>
    <message>
        <source>Add this to the region</source>
        <translation>Añadir esto a la región</translation>
    </message>
    <message>
        <source>Take this away from the region</source>
        <translation>Quitar esto de la región</translation>
    </message>
    <message>
        <source>Crosshair here</source>
        <translation>Cruz aquí</translation>
    </message>
    <message>
        <source>No focus</source>
        <translation>Sin foco</translation>
    </message>
</context>
<context>
    <name>ViewArea</name>
    <message>
        <source>&amp;Five views</source>
        <translation>&amp;Cinco vistas</translation>
    </message>
    <message>
        <source>C&amp;1 and C2</source>
        <translation>C&amp;1 y C2</translation>
    </message>
    <message>
        <source>&amp;3-D large, three slices</source>
        <translation>&amp;3D grande, tres cortes</translation>
    </message>
    <message>
        <source>&amp;Slices alone</source>
        <translation>&amp;Solo cortes</translation>
    </message>
    <message>
        <source>&amp;Axial large</source>
        <translation>&amp;Axial grande</translation>
    </message>
    <message>
        <source>Four: C1 and slices</source>
        <translation>Cuatro: C1 y cortes</translation>
    </message>
    <message>
        <source>C1 &amp;beside axial</source>
        <translation>C1 &amp;junto a axial</translation>
    </message>
</context>
<context>
    <name>WayOut</name>
    <message>
        <source>File → Choose series has the others</source>
        <translation>Archivo → Elegir serie contiene los demás</translation>
    </message>
    <message>
        <source>it holds one volume: open it without a time point</source>
        <translation>contiene un solo volumen: ábralo sin instante</translation>
    </message>
    <message>
        <source>open it without naming a series; File → Choose series then lists those that are there</source>
        <translation>ábralo sin indicar una serie; Archivo → Elegir serie muestra entonces las que hay</translation>
    </message>
    <message>
        <source>open it as a volume: a dialog asks for the size</source>
        <translation>ábralo como volumen: un diálogo pregunta el tamaño</translation>
    </message>
    <message>
        <source>File → Size of the voxels says otherwise</source>
        <translation>Archivo → Tamaño de los vóxeles lo cambia</translation>
    </message>
    <message>
        <source>open it without a size of voxels, which TIFF and raw files need</source>
        <translation>ábralo sin tamaño de vóxeles, que solo necesitan TIFF y archivos crudos</translation>
    </message>
    <message>
        <source>File → Kind of values says otherwise</source>
        <translation>Archivo → Tipo de valores lo cambia</translation>
    </message>
    <message>
        <source>put the file into the folder of its header</source>
        <translation>ponga el archivo en la carpeta de su cabecera</translation>
    </message>
    <message>
        <source>open it as it is stored: Load as is, in the notice about its slices</source>
        <translation>ábralo como está guardado: Cargar tal cual, en el aviso sobre sus cortes</translation>
    </message>
    <message>
        <source>DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze and TIFF are recognised by content</source>
        <translation>DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze y TIFF se reconocen por su contenido</translation>
    </message>
    <message>
        <source>&quot;Hide the table&quot; in the panel Context brings it back</source>
        <translation>«Ocultar la mesa» en el panel Contexto la devuelve</translation>
    </message>
    <message>
        <source>open a label map with File → Open labels</source>
        <translation>abra un mapa de etiquetas con Archivo → Abrir etiquetas</translation>
    </message>
    <message>
        <source>choose one in the panel Focus</source>
        <translation>elija uno en el panel Foco</translation>
    </message>
    <message>
        <source>choose the labels of the focus in the panel Focus</source>
        <translation>elija las etiquetas del foco en el panel Foco</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are, or put them beside it</source>
        <translation>abra de nuevo la sesión con Archivo → Abrir sesión, que pregunta dónde están, o póngalos junto a ella</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are</source>
        <translation>abra de nuevo la sesión con Archivo → Abrir sesión, que pregunta dónde están</translation>
    </message>
    <message>
        <source>open it without saying how its volume is read</source>
        <translation>ábrala sin decir cómo se lee su volumen</translation>
    </message>
    <message>
        <source>open it without files</source>
        <translation>ábrala sin archivos</translation>
    </message>
    <message>
        <source>raise the tolerance in the panel Focus</source>
        <translation>aumente la tolerancia en el panel Foco</translation>
    </message>
    <message>
        <source>click at another place, or take a point outside away</source>
        <translation>haga clic en otro lugar, o quite un punto exterior</translation>
    </message>
    <message>
        <source>select more, or take less away</source>
        <translation>seleccione más, o quite menos</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Actions</name>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;User guide</source>
        <translation>&amp;Guía del usuario</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>&amp;Visita guiada</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Teclas y ratón</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Fenestra</source>
        <translation>&amp;Acerca de Fenestra</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>&amp;Abrir carpeta…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>A&amp;brir archivo…</translation>
    </message>
    <message>
        <source>Open &amp;labels…</source>
        <translation>Abrir &amp;etiquetas…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Choose series…</source>
        <translation>Elegir serie…</translation>
    </message>
    <message>
        <source>Open s&amp;ession…</source>
        <translation>Ab&amp;rir sesión…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>&amp;Guardar sesión</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>G&amp;uardar sesión como…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Recent</source>
        <translation>Rec&amp;ientes</translation>
    </message>
    <message>
        <source>&amp;Built-in phantoms</source>
        <translation>&amp;Fantomas incorporados</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sa&amp;lir</translation>
    </message>
    <message>
        <source>Open a folder of &amp;masks…</source>
        <translation>Abrir &amp;carpeta de máscaras…</translation>
    </message>
    <message>
        <source>Open a &amp;table of labels…</source>
        <translation>Abrir &amp;tabla de etiquetas…</translation>
    </message>
    <message>
        <source>Si&amp;ze of the voxels…</source>
        <translation>Tamaño &amp;de los vóxeles…</translation>
    </message>
    <message>
        <source>&amp;Kind of values</source>
        <translation>Tipo de &amp;valores</translation>
    </message>
    <message>
        <source>&amp;CT</source>
        <translation>&amp;TC</translation>
    </message>
    <message>
        <source>&amp;MR</source>
        <translation>&amp;RM</translation>
    </message>
    <message>
        <source>&amp;PET or SPECT</source>
        <translation>&amp;PET o SPECT</translation>
    </message>
    <message>
        <source>&amp;Ultrasound</source>
        <translation>&amp;Ecografía</translation>
    </message>
    <message>
        <source>&amp;Other</source>
        <translation>&amp;Otro</translation>
    </message>
    <message>
        <source>Se&amp;gmentations of this series</source>
        <translation>Seg&amp;mentaciones de esta serie</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportar</translation>
    </message>
    <message>
        <source>A &amp;picture…</source>
        <translation>&amp;Imagen…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>A &amp;turntable…</source>
        <translation>&amp;Giro completo…</translation>
    </message>
    <message>
        <source>All &amp;labels…</source>
        <translation>&amp;Todas las etiquetas…</translation>
    </message>
    <message>
        <source>The &amp;focus as labels…</source>
        <translation>&amp;El foco como etiquetas…</translation>
    </message>
    <message>
        <source>The focus as a &amp;surface…</source>
        <translation>El &amp;foco como superficie…</translation>
    </message>
    <message>
        <source>&amp;Measures as a table…</source>
        <translation>&amp;Medidas como tabla…</translation>
    </message>
    <message>
        <source>%1, name hidden</source>
        <translation>%1, nombre oculto</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Nada todavía</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Olvidar estos</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pincel</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>&amp;Opposite brush</source>
        <translation>Pincel &amp;opuesto</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>Pincel &amp;más pequeño</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Pincel más &amp;grande</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Copiar imagen</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>A&amp;justes…</translation>
    </message>
    <message>
        <source>&amp;Window/level</source>
        <translation>Ventana/&amp;nivel</translation>
    </message>
    <message>
        <source>Of the data</source>
        <translation>De los datos</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>CT %1  (%2 / %3)</source>
        <translation>TC %1  (%2 / %3)</translation>
    </message>
    <message>
        <source>By &amp;number…</source>
        <translation>&amp;Por números…</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Invertir</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Distancia</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>Á&amp;ngulo</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Elipse</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rectángulo</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>E&amp;liminar</translation>
    </message>
    <message>
        <source>Delete all</source>
        <translation>Eliminar todo</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Show measures</source>
        <translation>&amp;Mostrar medidas</translation>
    </message>
    <message>
        <source>F&amp;ocus</source>
        <translation>&amp;Foco</translation>
    </message>
    <message>
        <source>&amp;No focus</source>
        <translation>&amp;Sin foco</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>&amp;Click chooses the focus</source>
        <translation>&amp;El clic elige el foco</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Lower tolerance</source>
        <translation>&amp;Reducir tolerancia</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>&amp;Higher tolerance</source>
        <translation>&amp;Aumentar tolerancia</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>V&amp;erify this picture…</source>
        <translation>&amp;Verificar esta imagen…</translation>
    </message>
    <message>
        <source>Computes pixels drawn at random again, in double precision, and states how exact the picture is</source>
        <translation>Recalcula píxeles elegidos al azar con doble precisión e indica cuán exacta es la imagen</translation>
    </message>
    <message>
        <source>All &amp;views</source>
        <translation>&amp;Todas las vistas</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Pantalla completa</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Reset la&amp;yout</source>
        <translation>&amp;Restablecer disposición</translation>
    </message>
    <message>
        <source>Li&amp;ght theme</source>
        <translation>Tema &amp;claro</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Mirar desde</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>Colocar cámaras</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>R&amp;establecer vista</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Reset &amp;all views</source>
        <translation>Restablecer todas &amp;las vistas</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Link the 3-D views</source>
        <translation>Enlazar vistas 3D</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>Pro&amp;yección paralela</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>Animar las cámaras</translation>
    </message>
    <message>
        <source>&amp;Freeze the opening</source>
        <translation>Co&amp;ngelar la abertura</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Congelar</translation>
    </message>
    <message>
        <source>Keeps the opening where it is while the cameras move, so that they look into it (%1)</source>
        <translation>Deja la abertura donde está mientras las cámaras se mueven, para poder mirar dentro (%1)</translation>
    </message>
    <message>
        <source>&amp;Crosshair</source>
        <translation>Cr&amp;uz</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Label &amp;overlay</source>
        <translation>&amp;Superponer etiquetas</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
    <message>
        <source>Corner &amp;text</source>
        <translation>Te&amp;xto en las esquinas</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>&amp;Hide the patient</source>
        <translation>Ocultar al paciente</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>&amp;Quality at rest</source>
        <translation>Cal&amp;idad en reposo</translation>
    </message>
    <message>
        <source>Bound on the error that sampling leaves in a pixel&apos;s colour</source>
        <translation>Cota del error que el muestreo deja en el color de un píxel</translation>
    </message>
    <message>
        <source>&amp;Slices</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Face C&amp;1</source>
        <translation>Frente a C&amp;1</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Face C&amp;2</source>
        <translation>Frente a C&amp;2</translation>
    </message>
    <message>
        <source>&amp;Slab</source>
        <translation>&amp;Bloque</translation>
    </message>
    <message>
        <source>&amp;Outlines in 3-D</source>
        <translation>Contornos &amp;en 3D</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>&amp;Reset the plane</source>
        <translation>Restablecer el &amp;plano</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Reset &amp;all planes</source>
        <translation>Restablecer todos &amp;los planos</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>&amp;Next series</source>
        <translation>Serie siguie&amp;nte</translation>
    </message>
    <message>
        <source>Ctrl+PgDown</source>
        <translation>Ctrl+PgDown</translation>
    </message>
    <message>
        <source>Pre&amp;vious series</source>
        <translation>Serie anteri&amp;or</translation>
    </message>
    <message>
        <source>Ctrl+PgUp</source>
        <translation>Ctrl+PgUp</translation>
    </message>
    <message>
        <source>&amp;Close study</source>
        <translation>Cerrar estudio</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Layo&amp;ut of the views</source>
        <translation>Disposición de las vistas</translation>
    </message>
    <message>
        <source>&amp;One view, the active one</source>
        <translation>&amp;Una vista, la activa</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>Vista siguiente</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Vista anterior</translation>
    </message>
    <message>
        <source>&amp;Keep this layout…</source>
        <translation>&amp;Guardar esta disposición…</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Olvidar</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>Guardar esta disposición</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Flip &amp;left and right</source>
        <translation>&amp;Voltear izquierda y derecha</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Flip &amp;up and down</source>
        <translation>Voltear &amp;arriba y abajo</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Turn by 90°</source>
        <translation>&amp;Girar 90°</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Tru&amp;e size</source>
        <translation>&amp;Tamaño real</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>This screen does not say how large it is, so that true size cannot be shown.</source>
        <translation>Esta pantalla no dice su tamaño, así que no se puede mostrar el tamaño real.</translation>
    </message>
    <message>
        <source>&amp;Neurological convention</source>
        <translation>&amp;Convención neurológica</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message numerus="yes">
        <source>%n slices a second</source>
        <translation>
            <numerusform>%n corte por segundo</numerusform>
            <numerusform>%n cortes por segundo</numerusform>
        </translation>
    </message>
    <message>
        <source>Play &amp;faster</source>
        <translation>&amp;Más rápido</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Play slo&amp;wer</source>
        <translation>Más &amp;despacio</translation>
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
        <translation>Cambiar teclas…</translation>
    </message>
    <message>
        <source>%1  (%2 % to %3 % of the values)</source>
        <translation>%1  (%2 % a %3 % de los valores)</translation>
    </message>
    <message>
        <source>SUV 0 to %1</source>
        <translation>SUV 0 a %1</translation>
    </message>
    <message>
        <source>&amp;My windows</source>
        <translation>&amp;Mis ventanas</translation>
    </message>
    <message>
        <source>&amp;Keep this window…</source>
        <translation>&amp;Guardar esta ventana…</translation>
    </message>
    <message>
        <source>%1  (%2 / %3)</source>
        <translation>%1  (%2 / %3)</translation>
    </message>
    <message>
        <source>Keep this window</source>
        <translation>Guardar esta ventana</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Cerebro</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastino</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Hueso</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Pulmón</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Ictus</translation>
    </message>
    <message>
        <source>Subdural</source>
        <translation>Subdural</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation>Hueso temporal</translation>
    </message>
    <message>
        <source>Spine, soft tissue</source>
        <translation>Columna, partes blandas</translation>
    </message>
    <message>
        <source>Spine, bone</source>
        <translation>Columna, hueso</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Habitual</translation>
    </message>
    <message>
        <source>All but outliers</source>
        <translation>Todo salvo atípicos</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Alto contraste</translation>
    </message>
    <message>
        <source>Bright structures</source>
        <translation>Estructuras brillantes</translation>
    </message>
    <message>
        <source>Send to archive…</source>
        <translation>Enviar al archivo…</translation>
    </message>
    <message>
        <source>The open series and its labels, to a server of the panel Archive</source>
        <translation>La serie abierta y sus etiquetas, a un servidor del panel Archivo</translation>
    </message>
    <message>
        <source>They are kept in</source>
        <translation>Se guardan en</translation>
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
        <translation>Conservar una imagen clave</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Save res&amp;ults…</source>
        <translation>Guardar re&amp;sultados…</translation>
    </message>
    <message>
        <source>Measures, segmentations, pictures and key images as DICOM objects, to a folder or an archive</source>
        <translation>Medidas, segmentaciones, imágenes e imágenes clave como objetos DICOM, en una carpeta o un archivo PACS</translation>
    </message>
    <message>
        <source>Arro&amp;w</source>
        <translation>&amp;Flecha</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>&amp;Texto</translation>
    </message>
    <message>
        <source>Change te&amp;xt…</source>
        <translation>Cambiar te&amp;xto…</translation>
    </message>
    <message>
        <source>Draw a &amp;path</source>
        <translation>Dibujar un tra&amp;yecto</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Path along the &amp;focus</source>
        <translation>Trayecto por el f&amp;oco</translation>
    </message>
    <message>
        <source>Open besi&amp;de</source>
        <translation>Abrir &amp;junto al actual</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>Car&amp;peta…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>F&amp;ile…</source>
        <translation>Arch&amp;ivo…</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>T&amp;wo studies</source>
        <translation>&amp;Dos estudios</translation>
    </message>
    <message>
        <source>&amp;Link by patient position</source>
        <translation>&amp;Vincular por la posición del paciente</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>&amp;Match points</source>
        <translation>&amp;Emparejar puntos</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>&amp;Forget the pair of points</source>
        <translation>&amp;Olvidar el par de puntos</translation>
    </message>
    <message>
        <source>&amp;Other study</source>
        <translation>O&amp;tro estudio</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Pa&amp;neles</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>De-identify…</source>
        <translation>Desidentificar…</translation>
    </message>
    <message>
        <source>Copies of the open series without what names the patient</source>
        <translation>Copias de la serie abierta sin lo que nombra al paciente</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::AppearancePanel</name>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Ready-made light: how surfaces give it back, from wherever it comes</source>
        <translation>Luz preparada: cómo la devuelven las superficies, venga de donde venga</translation>
    </message>
    <message>
        <source>own</source>
        <translation>propio</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveDock</name>
    <message>
        <source>Archive</source>
        <translation>Archivo</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveModel</name>
    <message>
        <source>Patient %1</source>
        <translation>Paciente %1</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Sin nombre</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Estudio %1</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Born %1</source>
        <translation>Nacimiento: %1</translation>
    </message>
    <message>
        <source>Sex %1</source>
        <translation>Sexo: %1</translation>
    </message>
    <message>
        <source>Accession number %1</source>
        <translation>Número de acceso %1</translation>
    </message>
    <message>
        <source>Study ID %1</source>
        <translation>ID del estudio %1</translation>
    </message>
    <message>
        <source>Part of the body: %1</source>
        <translation>Parte del cuerpo: %1</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>Protocolo: %1</translation>
    </message>
    <message>
        <source>Patient, study</source>
        <translation>Paciente, estudio</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchivePanel</name>
    <message>
        <source>No server is entered, so nothing goes over the network. Add the archive server (PACS) that holds your studies; its administrator knows what to enter.</source>
        <translation>No hay ningún servidor registrado, así que nada sale a la red. Añada el servidor de archivo (PACS) que tiene sus estudios; su administrador sabe qué introducir.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Buscando…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>The archive server that is asked</source>
        <translation>El servidor de archivo al que se pregunta</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Asks the server whether it answers (echo), and says what is wrong</source>
        <translation>Pregunta al servidor si responde (eco) y dice qué falla</translation>
    </message>
    <message>
        <source>Servers</source>
        <translation>Servidores</translation>
    </message>
    <message>
        <source>Add, edit and remove servers</source>
        <translation>Añadir, editar y quitar servidores</translation>
    </message>
    <message>
        <source>Add a server…</source>
        <translation>Añadir un servidor…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Editar…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the server</source>
        <translation>Quitar el servidor</translation>
    </message>
    <message>
        <source>Remove %1?</source>
        <translation>¿Quitar %1?</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Retrieves the study or series, and opens it once it is whole (double-click, or drag onto a view)</source>
        <translation>Recupera el estudio o la serie y lo abre cuando está completo (doble clic, o arrastrar a una vista)</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Fetches what is selected into the cache, to be opened later</source>
        <translation>Trae lo seleccionado a la caché, para abrirlo más tarde</translation>
    </message>
    <message>
        <source>More…</source>
        <translation>Más…</translation>
    </message>
    <message>
        <source>Asks for more of the studies that match</source>
        <translation>Pide más de los estudios que coinciden</translation>
    </message>
    <message>
        <source>Asking %1…</source>
        <translation>Preguntando a %1…</translation>
    </message>
    <message>
        <source>%1 answers, in %2 ms.</source>
        <translation>%1 responde, en %2 ms.</translation>
    </message>
    <message>
        <source>Nothing matches. Check the spelling; an asterisk stands for any text, as in *jane*.</source>
        <translation>Nada coincide. Compruebe la ortografía; un asterisco representa cualquier texto, como en *jane*.</translation>
    </message>
    <message>
        <source>Studies: %1, of patients: %2.</source>
        <translation>Estudios: %1, de pacientes: %2.</translation>
    </message>
    <message>
        <source>There are more: narrow the search, or ask for more.</source>
        <translation>Hay más: acote la búsqueda o pida más.</translation>
    </message>
    <message>
        <source>The server does not match by some of the fields.</source>
        <translation>El servidor no busca por algunos de los campos.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArrivalView</name>
    <message>
        <source>Looks through the slices that have come</source>
        <translation>Recorre los cortes que ya han llegado</translation>
    </message>
    <message>
        <source>Slice of those that have come</source>
        <translation>Corte entre los que ya han llegado</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Shows the views again; the retrieval goes on</source>
        <translation>Vuelve a mostrar las vistas; la recuperación continúa</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stops the retrieval; what came is kept</source>
        <translation>Detiene la recuperación; se conserva lo que ha llegado</translation>
    </message>
    <message>
        <source>Not whole: %1 of %2 images of this series are here. The study opens, with its 3-D views, once all are.</source>
        <translation>Incompleto: han llegado %1 de %2 imágenes de esta serie. El estudio se abre, con sus vistas 3D, cuando estén todas.</translation>
    </message>
    <message>
        <source>All images are here. The study is being opened.</source>
        <translation>Han llegado todas las imágenes. Se está abriendo el estudio.</translation>
    </message>
    <message>
        <source>Not whole: frame %1 of %2 is here. The study opens, with its 3-D views, once all are.</source>
        <translation>Incompleto: ha llegado la imagen %1 de %2. El estudio se abre, con sus vistas 3D, cuando estén todas.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::BestViews</name>
    <message>
        <source>One of the best viewpoints; click to look from there with C1</source>
        <translation>Uno de los mejores puntos de vista; clic para mirar desde allí con C1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Brush</name>
    <message>
        <source>Nothing is open: choose a focus first</source>
        <translation>Nada está abierto: elija primero un foco</translation>
    </message>
    <message>
        <source>The opening is switched off</source>
        <translation>La abertura está desactivada</translation>
    </message>
    <message>
        <source>This method cuts nothing away</source>
        <translation>Este método no corta nada</translation>
    </message>
    <message>
        <source>Nothing is there</source>
        <translation>Aquí no hay nada</translation>
    </message>
    <message>
        <source>Nothing was removed here</source>
        <translation>Aquí no se quitó nada</translation>
    </message>
    <message>
        <source>The brush may not cover the focus</source>
        <translation>El pincel no puede cubrir el foco</translation>
    </message>
    <message>
        <source>Open down to the focus already</source>
        <translation>Ya está abierto hasta el foco</translation>
    </message>
    <message>
        <source>The context&apos;s edges are switched off</source>
        <translation>Las aristas del contexto están desactivadas</translation>
    </message>
    <message>
        <source>Edges are drawn over the focus alone</source>
        <translation>Las aristas solo se dibujan sobre el foco</translation>
    </message>
    <message>
        <source>switch the opening on</source>
        <translation>activar la abertura</translation>
    </message>
    <message>
        <source>open instead</source>
        <translation>abrir en su lugar</translation>
    </message>
    <message>
        <source>let it cover the focus</source>
        <translation>permitir que cubra el foco</translation>
    </message>
    <message>
        <source>restore instead</source>
        <translation>restaurar en su lugar</translation>
    </message>
    <message>
        <source>switch the edges on</source>
        <translation>activar las aristas</translation>
    </message>
    <message>
        <source>take the adaptive cutaway</source>
        <translation>usar el seccionado adaptativo</translation>
    </message>
    <message>
        <source>Open the context</source>
        <translation>Abrir el contexto</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>Aristas del contexto</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>Pincel: %1</translation>
    </message>
    <message>
        <source>Space: %1</source>
        <translation>Espacio: %1</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %L2 mm</translation>
    </message>
    <message>
        <source>%1 to the surface</source>
        <translation>%1 hasta la superficie</translation>
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
        <translation>Restaurar hasta la superficie</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>Puede cubrir el foco</translation>
    </message>
    <message>
        <source>In the painted view only</source>
        <translation>Solo en la vista pintada</translation>
    </message>
    <message>
        <source>Paint in the 3-D views</source>
        <translation>Pintar en las vistas 3D</translation>
    </message>
    <message>
        <source>The left button paints; Ctrl+left drag still turns the view (P; E for the opposite brush)</source>
        <translation>El botón izquierdo pinta; Ctrl+arrastrar sigue girando la vista (P; E para el pincel opuesto)</translation>
    </message>
    <message>
        <source>Restore brings back all that was removed under the brush; otherwise no more than the depth</source>
        <translation>Restaurar devuelve todo lo quitado bajo el pincel; si no, solo hasta la profundidad</translation>
    </message>
    <message>
        <source>Otherwise restored tissue never hides the focus</source>
        <translation>Si no, el tejido restaurado nunca oculta el foco</translation>
    </message>
    <message>
        <source>Otherwise a stroke shows in both views</source>
        <translation>Si no, un trazo se ve en ambas vistas</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Cantidad</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CacheRow</name>
    <message>
        <source>Move…</source>
        <translation>Mover…</translation>
    </message>
    <message>
        <source>Chooses where objects are kept from now on; those of before stay where they are</source>
        <translation>Elige dónde se guardan los objetos desde ahora; los anteriores se quedan donde están</translation>
    </message>
    <message>
        <source>Keep objects of archives in</source>
        <translation>Guardar objetos de archivos en</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vaciar</translation>
    </message>
    <message>
        <source>Removes all objects that were retrieved; not while some come in</source>
        <translation>Elimina todos los objetos recuperados; no mientras llegan algunos</translation>
    </message>
    <message>
        <source>Remove all objects that were retrieved? The servers still have them, but sessions that refer to them find their data no more.</source>
        <translation>¿Eliminar todos los objetos recuperados? Los servidores aún los tienen, pero las sesiones que los usan ya no encontrarán sus datos.</translation>
    </message>
    <message>
        <source>Clears…</source>
        <translation>Vaciando…</translation>
    </message>
    <message>
        <source>Counts…</source>
        <translation>Contando…</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CamerasPanel</name>
    <message>
        <source>Place cameras</source>
        <translation>Colocar cámaras</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Look for the best view of the focus and the one that complements it (F5)</source>
        <translation>Busca la mejor vista del foco y la que la complementa (F5)</translation>
    </message>
    <message>
        <source>The two views see &lt;b&gt;%1 %&lt;/b&gt; of the focus&apos;s surface</source>
        <translation>Las dos vistas ven el &lt;b&gt;%1 %&lt;/b&gt; de la superficie del foco</translation>
    </message>
    <message>
        <source>Needs the 3-D views</source>
        <translation>Necesita las vistas 3D</translation>
    </message>
    <message>
        <source>Looking at the focus from all sides…</source>
        <translation>Mirando el foco desde todos los lados…</translation>
    </message>
    <message>
        <source>Click a structure on a slice</source>
        <translation>Haga clic en una estructura de un corte</translation>
    </message>
    <message>
        <source>Not placed yet for this focus</source>
        <translation>Aún sin colocar para este foco</translation>
    </message>
    <message>
        <source>Choose a focus first</source>
        <translation>Elija primero un foco</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Carving</name>
    <message>
        <source>Carve: %1</source>
        <translation>Tallar: %1</translation>
    </message>
    <message>
        <source>Bend the plane</source>
        <translation>Curvar el plano</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CarvingRows</name>
    <message>
        <source>Restore all</source>
        <translation>Restaurar todo</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>Tallar</translation>
    </message>
    <message>
        <source>The left button carves in all views when it is let go; Ctrl+left drag still turns the view</source>
        <translation>El botón izquierdo talla en todas las vistas al soltarlo; Ctrl+arrastrar sigue girando la vista</translation>
    </message>
    <message>
        <source>Brings back all that was carved away</source>
        <translation>Devuelve todo lo tallado</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ClippingPanel</name>
    <message>
        <source>Crop to a box</source>
        <translation>Recortar a una caja</translation>
    </message>
    <message>
        <source>Add a plane</source>
        <translation>Añadir un plano</translation>
    </message>
    <message>
        <source>Cut everything off behind a plane; up to three</source>
        <translation>Corta todo lo que queda detrás de un plano; hasta tres</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>Keep the other side of the plane</source>
        <translation>Conservar el otro lado del plano</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the plane</source>
        <translation>Quitar el plano</translation>
    </message>
    <message>
        <source>Clip nothing</source>
        <translation>No recortar nada</translation>
    </message>
    <message>
        <source>Switch off the box, and remove all planes</source>
        <translation>Desactivar la caja y quitar todos los planos</translation>
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
        <translation>Extremo derecho de la caja (del paciente)</translation>
    </message>
    <message>
        <source>The patient&apos;s left end of the box</source>
        <translation>Extremo izquierdo de la caja (del paciente)</translation>
    </message>
    <message>
        <source>The front end of the box</source>
        <translation>Extremo anterior de la caja</translation>
    </message>
    <message>
        <source>The back end of the box</source>
        <translation>Extremo posterior de la caja</translation>
    </message>
    <message>
        <source>The lower end of the box</source>
        <translation>Extremo inferior de la caja</translation>
    </message>
    <message>
        <source>The upper end of the box</source>
        <translation>Extremo superior de la caja</translation>
    </message>
    <message>
        <source>Drag a plane&apos;s square to move it, and the ball at its arrow to tilt it, in any view</source>
        <translation>Arrastre el cuadrado de un plano para moverlo y la bola de su flecha para inclinarlo, en cualquier vista</translation>
    </message>
    <message>
        <source>Where the plane lies along its arrow</source>
        <translation>Dónde está el plano a lo largo de su flecha</translation>
    </message>
    <message>
        <source>From the axial slice</source>
        <translation>Del corte axial</translation>
    </message>
    <message>
        <source>From the sagittal slice</source>
        <translation>Del corte sagital</translation>
    </message>
    <message>
        <source>From the coronal slice</source>
        <translation>Del corte coronal</translation>
    </message>
    <message>
        <source>Facing camera C1</source>
        <translation>Frente a la cámara C1</translation>
    </message>
    <message>
        <source>3-D pictures show only the inside of a box along the volume&apos;s axes</source>
        <translation>Las imágenes 3D muestran solo el interior de una caja según los ejes del volumen</translation>
    </message>
    <message>
        <source>As the transfer function</source>
        <translation>Como la función de transferencia</translation>
    </message>
    <message>
        <source>Grey, as the slices</source>
        <translation>Gris, como los cortes</translation>
    </message>
    <message>
        <source>What the cut faces show. Grey takes the window that the slices have now</source>
        <translation>Lo que muestran las caras de corte. Gris toma la ventana actual de los cortes</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>Caras de corte</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Recortar</translation>
    </message>
    <message>
        <source>Flip the clip plane</source>
        <translation>Invertir el plano de recorte</translation>
    </message>
    <message>
        <source>Remove the clip plane</source>
        <translation>Quitar el plano de recorte</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>Mover el plano de recorte</translation>
    </message>
    <message>
        <source>Add a clip plane</source>
        <translation>Añadir un plano de recorte</translation>
    </message>
    <message>
        <source>Plane %1, keeps %2</source>
        <translation>Plano %1, conserva %2</translation>
    </message>
    <message>
        <source>Labels that are never clipped are chosen in the list of structures, by their role.</source>
        <translation>Las etiquetas que nunca se recortan se eligen en la lista de estructuras, por su función.</translation>
    </message>
    <message>
        <source>Structures that are never clipped: %1</source>
        <translation>Estructuras que nunca se recortan: %1</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Planos de recorte</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ContextLayerPanel</name>
    <message>
        <source>Context edges: %1</source>
        <translation>Aristas del contexto: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CopyRows</name>
    <message>
        <source>Copy the &amp;value</source>
        <translation>Copiar el &amp;valor</translation>
    </message>
    <message>
        <source>&amp;Copy the rows</source>
        <translation>&amp;Copiar las filas</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CutawayPanel</name>
    <message>
        <source>own</source>
        <translation>propio</translation>
    </message>
    <message>
        <source>Ready-made border and context edges</source>
        <translation>Borde y aristas del contexto ya preparados</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Smooth edges, by several rays a pixel, are the adaptive cutaway&apos;s alone</source>
        <translation>Las aristas suaves, con varios rayos por píxel, son solo del seccionado adaptativo</translation>
    </message>
    <message>
        <source>This method has no width: it cuts nothing away</source>
        <translation>Este método no tiene ancho: no corta nada</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the lens decide on it</source>
        <translation>Este método no tiene ancho propio: lo deciden el foco y la lente</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the angle decide on it</source>
        <translation>Este método no tiene ancho propio: lo deciden el foco y el ángulo</translation>
    </message>
    <message>
        <source>The line of this method is the rim of its lens</source>
        <translation>La línea de este método es el borde de su lente</translation>
    </message>
    <message>
        <source>This method has no line: it cuts nothing away</source>
        <translation>Este método no tiene línea: no corta nada</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DeidentifyDialog</name>
    <message>
        <source>removed</source>
        <translation>eliminado</translation>
    </message>
    <message>
        <source>emptied</source>
        <translation>vaciado</translation>
    </message>
    <message>
        <source>replaced by a dummy</source>
        <translation>sustituido por un valor ficticio</translation>
    </message>
    <message>
        <source>replaced by a new UID</source>
        <translation>sustituido por un UID nuevo</translation>
    </message>
    <message>
        <source>cleaned</source>
        <translation>depurado</translation>
    </message>
    <message>
        <source>De-identify</source>
        <translation>Desidentificar</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Escribiendo…</translation>
    </message>
    <message>
        <source>Copies of the open series, images: %1</source>
        <translation>Copias de la serie abierta, imágenes: %1</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>Todas las etiquetas, como segmentación DICOM</translation>
    </message>
    <message>
        <source>Their names go with the descriptions, unless these are cleaned</source>
        <translation>Sus nombres desaparecen con las descripciones, salvo que estas se depuren</translation>
    </message>
    <message>
        <source>Keep dates and times</source>
        <translation>Conservar fechas y horas</translation>
    </message>
    <message>
        <source>As they are; with them a patient may be found</source>
        <translation>Tal como son; con ellas se puede encontrar a un paciente</translation>
    </message>
    <message>
        <source>Keep UIDs</source>
        <translation>Conservar los UID</translation>
    </message>
    <message>
        <source>As they are; whoever has the originals can tell which is which</source>
        <translation>Tal como son; quien tenga los originales puede relacionarlos</translation>
    </message>
    <message>
        <source>Clean descriptions</source>
        <translation>Depurar descripciones</translation>
    </message>
    <message>
        <source>Of descriptions, the words stay that say nothing about a person; otherwise they go</source>
        <translation>De las descripciones quedan las palabras que no dicen nada de una persona; si no, desaparecen</translation>
    </message>
    <message>
        <source>Clean graphics</source>
        <translation>Depurar gráficos</translation>
    </message>
    <message>
        <source>The shapes of annotations stay; overlays and curves go in any case</source>
        <translation>Las formas de las anotaciones quedan; las superposiciones y curvas desaparecen siempre</translation>
    </message>
    <message>
        <source>Remove the face, from a head in CT or MR</source>
        <translation>Eliminar el rostro de una cabeza en TC o RM</translation>
    </message>
    <message>
        <source>All in front of a plane from the brow to the chin is blanked. Look at the copies, as slices and in 3-D: a nodded or turned head may keep a part of its face, or lose some brain</source>
        <translation>Se borra todo lo que está delante de un plano de la ceja al mentón. Mire las copias, como cortes y en 3D: una cabeza inclinada o girada puede conservar parte del rostro o perder algo de cerebro</translation>
    </message>
    <message>
        <source>Look at the copies before you give them away: no program finds a name that is written into a picture, or knows whether all of a face is gone.</source>
        <translation>Mire las copias antes de entregarlas: ningún programa encuentra un nombre escrito en la imagen ni sabe si un rostro ha desaparecido del todo.</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Lo que cambia</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Atributo</translation>
    </message>
    <message>
        <source>Becomes</source>
        <translation>Pasa a ser</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Veces</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>To a new folder in</source>
        <translation>A una carpeta nueva en</translation>
    </message>
    <message>
        <source>A folder named de-identified is made there</source>
        <translation>Allí se crea una carpeta llamada de-identified</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>Al archivo PACS</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>El servidor responde por cada objeto</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Servidor</translation>
    </message>
    <message>
        <source>Keep a map in the file</source>
        <translation>Conservar una tabla en el archivo</translation>
    </message>
    <message>
        <source>Old and new UIDs and patients&apos; numbers, readable by you alone. Without it nobody can tell which was which</source>
        <translation>UID y números de paciente antiguos y nuevos, legibles solo por usted. Sin ella nadie puede relacionarlos</translation>
    </message>
    <message>
        <source>File of the map</source>
        <translation>Archivo de la tabla</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Folder of the copies</source>
        <translation>Carpeta de las copias</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tablas</translation>
    </message>
    <message>
        <source>%1 copies are in %2.</source>
        <translation>%1 copias están en %2.</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>Copia %1</translation>
    </message>
    <message>
        <source>Copies without the face: %1. Look at each of them.</source>
        <translation>Copias sin el rostro: %1. Mire cada una.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DockFolding</name>
    <message>
        <source>Fold %1</source>
        <translation>Plegar %1</translation>
    </message>
    <message>
        <source>Folds this panel to its title, so that others have more room</source>
        <translation>Pliega este panel a su título, para dar más sitio a los demás</translation>
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
        <translation>Foco</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Función de transferencia</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>Nunca recortado</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Size of the region</source>
        <translation>Tamaño de la región</translation>
    </message>
    <message>
        <source>Add to the region</source>
        <translation>Añadir a la región</translation>
    </message>
    <message>
        <source>Take away from the region</source>
        <translation>Quitar de la región</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>Pintar la región</translation>
    </message>
    <message>
        <source>Erase from the region</source>
        <translation>Borrar de la región</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>The focus before still shows, until you open to the region</source>
        <translation>Sigue a la vista el foco anterior, hasta que abra a la región</translation>
    </message>
    <message>
        <source>Growing the region; the focus before still shows</source>
        <translation>La región crece; sigue a la vista el foco anterior</translation>
    </message>
    <message>
        <source>Growing the region; this is a first part</source>
        <translation>La región crece; esta es una primera parte</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Exports</name>
    <message>
        <source>NRRD, with names and colours</source>
        <translation>NRRD, con nombres y colores</translation>
    </message>
    <message>
        <source>DICOM segmentation, with names and colours</source>
        <translation>Segmentación DICOM, con nombres y colores</translation>
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
        <translation>Exportar todas las etiquetas</translation>
    </message>
    <message>
        <source>Export the focus as labels</source>
        <translation>Exportar el foco como etiquetas</translation>
    </message>
    <message>
        <source>%1 in mm, %2 axes</source>
        <translation>%1 en mm, ejes %2</translation>
    </message>
    <message>
        <source>Export the focus as a surface</source>
        <translation>Exportar el foco como superficie</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>Tabla (CSV)</translation>
    </message>
    <message>
        <source>Export the measures</source>
        <translation>Exportar las medidas</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Se escribió %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FileOpener</name>
    <message>
        <source>Open as volume</source>
        <translation>Abrir como volumen</translation>
    </message>
    <message>
        <source>Open as labels of this volume</source>
        <translation>Abrir como etiquetas de este volumen</translation>
    </message>
    <message>
        <source>Volumes (*.dcm %1);;All files (*)</source>
        <translation>Volúmenes (*.dcm %1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Abrir un volumen</translation>
    </message>
    <message>
        <source>Open a DICOM folder</source>
        <translation>Abrir una carpeta DICOM</translation>
    </message>
    <message>
        <source>Label maps (*.dcm %1);;All files (*)</source>
        <translation>Mapas de etiquetas (*.dcm %1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open a label map</source>
        <translation>Abrir un mapa de etiquetas</translation>
    </message>
    <message>
        <source>Open a folder of masks</source>
        <translation>Abrir una carpeta de máscaras</translation>
    </message>
    <message>
        <source>Tables of labels (*.txt *.tsv *.csv *.label *.ctbl *.lut);;All files (*)</source>
        <translation>Tablas de etiquetas (*.txt *.tsv *.csv *.label *.ctbl *.lut);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open a table of labels</source>
        <translation>Abrir una tabla de etiquetas</translation>
    </message>
    <message>
        <source>How large the voxels are:</source>
        <translation>Tamaño de los vóxeles:</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FocusPanel</name>
    <message>
        <source>No labels. Click a structure in a picture, open a label map (Ctrl+L), or choose a range of values below.</source>
        <translation>Sin etiquetas. Haga clic en una estructura de una imagen, abra un mapa de etiquetas (Ctrl+L) o elija abajo un intervalo de valores.</translation>
    </message>
    <message>
        <source>Focus on values</source>
        <translation>Foco por valores</translation>
    </message>
    <message>
        <source>Find a structure</source>
        <translation>Buscar una estructura</translation>
    </message>
    <message>
        <source>The focus is everything whose value lies in this range</source>
        <translation>El foco es todo aquello cuyo valor está en este intervalo</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Without islands below</source>
        <translation>Sin islas menores de</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>Pintar la región</translation>
    </message>
    <message>
        <source>The left button paints the region in focus in all views; with Shift it erases</source>
        <translation>El botón izquierdo pinta la región del foco en todas las vistas; con Mayús, borra</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>Nothing open</source>
        <translation>Nada abierto</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::GuideWindow</name>
    <message>
        <source>Not on this page</source>
        <translation>No está en esta página</translation>
    </message>
    <message>
        <source>User guide of Fenestra</source>
        <translation>Guía del usuario de Fenestra</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation>Shift+F3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>F3</source>
        <translation>F3</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Buscar en esta página</translation>
    </message>
    <message>
        <source>Return goes to the next place (Ctrl+F)</source>
        <translation>Intro va al siguiente lugar (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ImportanceList</name>
    <message>
        <source>What hides a label of a higher level is opened for it; what has the same level or a higher one never is. All else has level 0.</source>
        <translation>Lo que oculta una etiqueta de nivel superior se abre para ella; lo que tiene el mismo nivel o uno superior, nunca. Todo lo demás tiene el nivel 0.</translation>
    </message>
    <message>
        <source>Another label…</source>
        <translation>Otra etiqueta…</translation>
    </message>
    <message>
        <source>Gives a label that is not in focus a level of importance</source>
        <translation>Da un nivel de importancia a una etiqueta que no está en el foco</translation>
    </message>
    <message>
        <source>Level of importance</source>
        <translation>Nivel de importancia</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyBindings</name>
    <message>
        <source>It is not JSON, from character %1 on: %2.</source>
        <translation>No es JSON, desde el carácter %1: %2.</translation>
    </message>
    <message>
        <source>It does not hold Fenestra&apos;s keys: choose a file that Export in this dialog wrote.</source>
        <translation>No contiene las teclas de Fenestra: elija un archivo escrito con Exportar en este diálogo.</translation>
    </message>
    <message>
        <source>It was written by a newer version of Fenestra.</source>
        <translation>Lo escribió una versión más reciente de Fenestra.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, of &quot;%2&quot;, is no key.</source>
        <translation>«%1», de «%2», no es una tecla.</translation>
    </message>
    <message>
        <source>%1, of &quot;%2&quot;, is a key of the views.</source>
        <translation>%1, de «%2», es una tecla de las vistas.</translation>
    </message>
    <message>
        <source>%1 is the key of both &quot;%2&quot; and &quot;%3&quot;.</source>
        <translation>%1 es la tecla de «%2» y de «%3».</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImages</name>
    <message>
        <source>Key image %1</source>
        <translation>Imagen clave %1</translation>
    </message>
    <message>
        <source>Keep a key image</source>
        <translation>Conservar una imagen clave</translation>
    </message>
    <message>
        <source>Return to a key image</source>
        <translation>Volver a una imagen clave</translation>
    </message>
    <message>
        <source>Rename a key image</source>
        <translation>Cambiar el nombre de una imagen clave</translation>
    </message>
    <message>
        <source>Delete a key image</source>
        <translation>Eliminar una imagen clave</translation>
    </message>
    <message>
        <source>Move a key image</source>
        <translation>Mover una imagen clave</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImagesPanel</name>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Conservar</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Imágenes clave</translation>
    </message>
    <message>
        <source>Keeps the cameras, slices, crosshair, focus and look as they are now</source>
        <translation>Conserva las cámaras, los cortes, la cruz, el foco y el aspecto como están ahora</translation>
    </message>
    <message>
        <source>Moves the key image up</source>
        <translation>Sube la imagen clave</translation>
    </message>
    <message>
        <source>Moves the key image down</source>
        <translation>Baja la imagen clave</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeysDialog</name>
    <message>
        <source>Change keys</source>
        <translation>Cambiar teclas</translation>
    </message>
    <message>
        <source>Show entries with these words or keys</source>
        <translation>Mostrar entradas con estas palabras o teclas</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>&amp;Take it</source>
        <translation>&amp;Tomarla</translation>
    </message>
    <message>
        <source>Gives the key to this entry, and the other one loses it</source>
        <translation>Da la tecla a esta entrada, y la otra la pierde</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Sin tecla</translation>
    </message>
    <message>
        <source>As it &amp;was</source>
        <translation>&amp;Como estaba</translation>
    </message>
    <message>
        <source>The key that the entry comes with</source>
        <translation>La tecla con la que viene la entrada</translation>
    </message>
    <message>
        <source>&amp;Key</source>
        <translation>T&amp;ecla</translation>
    </message>
    <message>
        <source>&amp;All as they were</source>
        <translation>T&amp;odas como estaban</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importar…</translation>
    </message>
    <message>
        <source>Click into the box and press the key. Changed keys are bold.</source>
        <translation>Haga clic en la casilla y pulse la tecla. Las teclas cambiadas están en negrita.</translation>
    </message>
    <message>
        <source>%1 is a key of the views: no entry can have it.</source>
        <translation>%1 es una tecla de las vistas: ninguna entrada puede tenerla.</translation>
    </message>
    <message>
        <source>%1 is the key of %2 → %3. Take it?</source>
        <translation>%1 es la tecla de %2 → %3. ¿Tomarla?</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>Exportar teclas</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Escrito en %1.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>No se puede escribir %1: %2. Elija otra carpeta.</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>Importar teclas</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>Teclas (*.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>No se puede leer %1: %2.</translation>
    </message>
    <message>
        <source>Taken over from %1.</source>
        <translation>Tomado de %1.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditPanel</name>
    <message>
        <source>Grow</source>
        <translation>Ampliar</translation>
    </message>
    <message>
        <source>Add what lies within this distance; other labels keep their voxels</source>
        <translation>Añade lo que está dentro de esta distancia; las demás etiquetas conservan sus vóxeles</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Reducir</translation>
    </message>
    <message>
        <source>Remove what lies within this distance of the outside</source>
        <translation>Quita lo que está a esta distancia del exterior</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>Quitar islas</translation>
    </message>
    <message>
        <source>Remove separate parts smaller than this</source>
        <translation>Quita las partes separadas menores que esto</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Rellenar huecos</translation>
    </message>
    <message>
        <source>Add what the label encloses</source>
        <translation>Añade lo que la etiqueta encierra</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditor</name>
    <message>
        <source>Grow label</source>
        <translation>Ampliar etiqueta</translation>
    </message>
    <message>
        <source>Shrink label</source>
        <translation>Reducir etiqueta</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Rellenar huecos</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>Quitar islas</translation>
    </message>
    <message>
        <source>Keep region</source>
        <translation>Conservar la región</translation>
    </message>
    <message>
        <source>All 65535 values that a label may have are in use</source>
        <translation>Los 65535 valores que puede tener una etiqueta están en uso</translation>
    </message>
    <message>
        <source>Nothing would be left of the label</source>
        <translation>No quedaría nada de la etiqueta</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelList</name>
    <message>
        <source>No structure&apos;s name has these words.</source>
        <translation>Ninguna estructura tiene estas palabras.</translation>
    </message>
    <message>
        <source>Show the label</source>
        <translation>Mostrar la etiqueta</translation>
    </message>
    <message>
        <source>Do not show the label</source>
        <translation>No mostrar la etiqueta</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>Color de la etiqueta</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Foco</translation>
    </message>
    <message>
        <source>What the view opens to</source>
        <translation>A lo que se abre la vista</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>Nunca recortado</translation>
    </message>
    <message>
        <source>Stays outside the crop box and behind clip planes, as part of the context</source>
        <translation>Permanece fuera de la caja y tras los planos de recorte, como parte del contexto</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Color…</translation>
    </message>
    <message>
        <source>The label map&apos;s own colour</source>
        <translation>El color propio del mapa de etiquetas</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Estructuras</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelModel</name>
    <message>
        <source>Label %1</source>
        <translation>Etiqueta %1</translation>
    </message>
    <message>
        <source>Label %1. Tick it to open the view to it; double-click to focus on it alone and go there; F2 renames it.</source>
        <translation>Etiqueta %1. Márquela para abrir la vista a ella; doble clic para enfocarla solo a ella e ir allí; F2 la renombra.</translation>
    </message>
    <message>
        <source>Click to choose another colour</source>
        <translation>Clic para elegir otro color</translation>
    </message>
    <message>
        <source>Click to show it or not: slices tint what is visible, and 3-D pictures draw it while it is in focus or protected</source>
        <translation>Clic para mostrarla o no: los cortes tiñen lo visible y las imágenes 3D la dibujan si está en el foco o protegida</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Focus: what the view opens to</source>
        <translation>Foco: a lo que se abre la vista</translation>
    </message>
    <message>
        <source>Opacity of its surface, however thick it is, and of its tint on slices; click to change it. At 0 % it is left out of the 3-D pictures.</source>
        <translation>Opacidad de su superficie, sea cual sea su grosor, y de su tinte en los cortes; clic para cambiarla. Con 0 % no aparece en las imágenes 3D.</translation>
    </message>
    <message>
        <source>C1 sees %1 of its surface, C2 %2, both together %3: measured where cameras are tried, nearest to these</source>
        <translation>C1 ve %1 de su superficie, C2 %2, ambas juntas %3: medido en las cámaras probadas más cercanas</translation>
    </message>
    <message>
        <source>Share of its surface that C1 and C2 see; measured for labels in focus when cameras are placed</source>
        <translation>Parte de su superficie que ven C1 y C2; se mide para las etiquetas del foco al colocar las cámaras</translation>
    </message>
    <message numerus="yes">
        <source>%n label(s) without voxels</source>
        <translation>
            <numerusform>%n etiqueta sin vóxeles</numerusform>
            <numerusform>%n etiquetas sin vóxeles</numerusform>
        </translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Visto</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelTable</name>
    <message>
        <source>&amp;Copy all (CSV)</source>
        <translation>&amp;Copiar todo (CSV)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Guardar…</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>Tabla de etiquetas</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Mean, %1</source>
        <translation>Media, %1</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>DE</translation>
    </message>
    <message>
        <source>Extent, mm</source>
        <translation>Extensión, mm</translation>
    </message>
    <message>
        <source>Seen, C1</source>
        <translation>Visible, C1</translation>
    </message>
    <message>
        <source>Seen, C2</source>
        <translation>Visible, C2</translation>
    </message>
    <message>
        <source>Sides of its box along the patient: left to right, front to back, foot to head</source>
        <translation>Lados de su caja a lo largo del paciente: izquierda a derecha, delante a atrás, pies a cabeza</translation>
    </message>
    <message>
        <source>Share of its surface that the camera sees; measured for labels in focus when cameras are placed</source>
        <translation>Parte de su superficie que ve la cámara; se mide para las etiquetas en foco cuando se colocan las cámaras</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>Etiqueta %1</translation>
    </message>
    <message>
        <source>This study has no labels. Open some from the File menu, or keep a grown region as a label.</source>
        <translation>Este estudio no tiene etiquetas. Ábralas desde el menú Archivo o conserve una región crecida como etiqueta.</translation>
    </message>
    <message>
        <source>Measuring the labels…</source>
        <translation>Midiendo las etiquetas…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Save the label table</source>
        <translation>Guardar la tabla de etiquetas</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>Tabla (CSV)</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Escrito en %1.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LoadingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MainWindow</name>
    <message>
        <source>Growing the region</source>
        <translation>La región crece</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>Editando la etiqueta</translation>
    </message>
    <message>
        <source>Verifying the picture</source>
        <translation>Verificando la imagen</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Abriendo…</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Escribiendo…</translation>
    </message>
    <message>
        <source>%1 was named at the start and is not open.</source>
        <translation>%1 se indicó al inicio y no está abierto.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Other data</source>
        <translation>Otros datos</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>Colocar cámaras</translation>
    </message>
    <message>
        <source>The region is %1, which is %2 % of the body. The slices show its outline; open the 3-D views to it?</source>
        <translation>La región mide %1, el %2 % del cuerpo. Los cortes muestran su contorno; ¿abrir las vistas 3D a ella?</translation>
    </message>
    <message>
        <source>The region, %1, has a doubtful border. The slices show its outline; open the 3-D views to it?</source>
        <translation>La región, de %1, tiene un borde dudoso. Los cortes muestran su contorno; ¿abrir las vistas 3D a ella?</translation>
    </message>
    <message>
        <source>Open to it</source>
        <translation>Abrir a ella</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Deshacerlo</translation>
    </message>
    <message>
        <source>%1 lies over other labels and took %2 from them; undo brings them back.</source>
        <translation>%1 está sobre otras etiquetas y les quitó %2; Deshacer los devuelve.</translation>
    </message>
    <message>
        <source>There are %1 key images; delete some to keep another.</source>
        <translation>Hay %1 imágenes clave; elimine algunas para conservar otra.</translation>
    </message>
    <message>
        <source>The patient may lie differently in the two studies: linked without a pair of points, the same coordinates may be other places. Unlink, put both crosshairs onto the same point, and choose Match points; the link is as good as that pair.</source>
        <translation>El paciente puede estar colocado de otra forma en los dos estudios: sin un par de puntos, las mismas coordenadas pueden ser otros lugares. Desvincule, ponga ambas cruces en el mismo punto y elija Emparejar puntos; el vínculo es tan bueno como ese par.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MeasureMode</name>
    <message>
        <source>Delete measure</source>
        <translation>Eliminar medida</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>Eliminar todas las medidas</translation>
    </message>
    <message>
        <source>Move measure</source>
        <translation>Mover medida</translation>
    </message>
    <message>
        <source>Change text</source>
        <translation>Cambiar el texto</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::NoticeBar</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Files…</source>
        <translation>Archivos…</translation>
    </message>
    <message>
        <source>Files concerned</source>
        <translation>Archivos afectados</translation>
    </message>
    <message>
        <source>Slices scanned: %1, %2 mm apart for the most part
Planes shown: %3, %4 mm apart
Farthest from its place as shown: %5 mm; with the slices spread evenly: %6 mm
Planes in wide gaps: %7
Voxels outside of what was scanned: %8</source>
        <translation>Cortes adquiridos: %1, separados en general %L2 mm
Planos mostrados: %3, separados %L4 mm
Mayor distancia a su lugar, tal como se muestra: %L5 mm; con los cortes repartidos por igual: %L6 mm
Planos en huecos anchos: %7
Vóxeles fuera de lo adquirido: %8</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>Geometry report</source>
        <translation>Informe de geometría</translation>
    </message>
    <message>
        <source>Load as is</source>
        <translation>Cargar tal cual</translation>
    </message>
    <message>
        <source>Regularise</source>
        <translation>Regularizar</translation>
    </message>
    <message>
        <source>Make straight</source>
        <translation>Enderezar</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathCameras</name>
    <message>
        <source>Cameras follow the path</source>
        <translation>Las cámaras siguen el trayecto</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathMode</name>
    <message>
        <source>Draw a path</source>
        <translation>Dibujar un trayecto</translation>
    </message>
    <message>
        <source>Move a point of the path</source>
        <translation>Mover un punto del trayecto</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathOpening</name>
    <message>
        <source>Radius of the opening</source>
        <translation>Radio de la abertura</translation>
    </message>
    <message>
        <source>Opening along the path</source>
        <translation>Abertura a lo largo del trayecto</translation>
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
        <translation>Ambas vistas 3D</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Todas las vistas</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>With crosshair, text and scale</source>
        <translation>Con cruz, texto y escala</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Guardar una imagen</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Guardar un giro completo</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Pictures in a turn</source>
        <translation>Imágenes por vuelta</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Imágenes por segundo</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureExports</name>
    <message>
        <source>Save a picture</source>
        <translation>Guardar una imagen</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could turn.</source>
        <translation>No hay en pantalla ninguna vista 3D que pueda girar.</translation>
    </message>
    <message>
        <source>PNG, one for each picture</source>
        <translation>PNG, uno por imagen</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>Película MP4</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Guardar un giro completo</translation>
    </message>
    <message>
        <source>Drawing %1…</source>
        <translation>Dibujando %1…</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name, or delete the pictures of an earlier turntable.</source>
        <translation>%1 ya existe: elija otro nombre o elimine las imágenes de un giro anterior.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Se escribió %1</translation>
    </message>
    <message>
        <source>Copied the picture</source>
        <translation>Imagen copiada</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started; save PNGs instead.</source>
        <translation>No se puede iniciar ffmpeg; guarde PNG en su lugar.</translation>
    </message>
    <message>
        <source>ffmpeg could not write %1: %2</source>
        <translation>ffmpeg no pudo escribir %1: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>No se puede escribir %1: %2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureMaker</name>
    <message>
        <source>There is no memory for a picture of %1 × %2 pixels.</source>
        <translation>No hay memoria para una imagen de %1 × %2 píxeles.</translation>
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
        <translation>No se puede medir el foco: %1</translation>
    </message>
    <message>
        <source>No view of that point: %1</source>
        <translation>No hay vista de ese punto: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PlacementForm</name>
    <message>
        <source>Place the cameras when a focus is chosen</source>
        <translation>Colocar las cámaras al elegir un foco</translation>
    </message>
    <message>
        <source>Second view follows the first</source>
        <translation>La segunda vista sigue a la primera</translation>
    </message>
    <message>
        <source>Find both views together</source>
        <translation>Buscar ambas vistas a la vez</translation>
    </message>
    <message>
        <source>The focus</source>
        <translation>El foco</translation>
    </message>
    <message>
        <source>A point clicked on a slice</source>
        <translation>Un punto marcado en un corte</translation>
    </message>
    <message>
        <source>What the cameras look at.
The focus: its best view and one that complements it.
A point clicked on a slice: a click there turns both views to the structure at that point, which needs no label (LiveSync, Kohlmann et al. 2007)</source>
        <translation>Qué miran las cámaras.
El foco: su mejor vista y otra que la complementa.
Un punto marcado en un corte: un clic vuelve ambas vistas hacia la estructura de ese punto, que no necesita etiqueta (LiveSync, Kohlmann et al. 2007)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How far from the point its structure counts</source>
        <translation>Hasta qué distancia del punto cuenta su estructura</translation>
    </message>
    <message numerus="yes">
        <source>%n views</source>
        <translation>
            <numerusform>%n vista</numerusform>
            <numerusform>%n vistas</numerusform>
        </translation>
    </message>
    <message>
        <source>Finer near the best</source>
        <translation>Más fino cerca de las mejores</translation>
    </message>
    <message>
        <source>From how many sides the focus is looked at, evenly all around (12·n² HEALPix directions), or ever finer around the best ones</source>
        <translation>Desde cuántos lados se mira el foco, por igual en todo el contorno (12·n² direcciones HEALPix), o cada vez más fino en torno a las mejores</translation>
    </message>
    <message>
        <source>To its right</source>
        <translation>A su derecha</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>Alrededor</translation>
    </message>
    <message>
        <source>Where the second view may be, always 60° to 120° from the first.
To its right: the half sphere c2·a ≥ 0 around the first view&apos;s right axis a. All around: the band |c1·c2| ≤ sin δ</source>
        <translation>Dónde puede estar la segunda vista, siempre a 60°–120° de la primera.
A su derecha: la semiesfera c2·a ≥ 0 en torno al eje derecho a de la primera vista. Alrededor: la banda |c1·c2| ≤ sin δ</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>δ: how far the second view may leave the right angle to the first</source>
        <translation>δ: cuánto puede apartarse la segunda vista del ángulo recto con la primera</translation>
    </message>
    <message>
        <source>Choose the two views that together see most of the focus&apos;s surface.
Off: first the best view, then the best one beside it</source>
        <translation>Elige las dos vistas que juntas ven más superficie del foco.
Desactivado: primero la mejor vista, luego la mejor junto a ella</translation>
    </message>
    <message>
        <source>What two views are chosen by: w · share of the surface seen + (1 − w) · mean quality of the views</source>
        <translation>Según qué se eligen dos vistas: w · parte de superficie vista + (1 − w) · calidad media de las vistas</translation>
    </message>
    <message>
        <source>When the first view is turned, the second goes to the best view beside it</source>
        <translation>Al girar la primera vista, la segunda va a la mejor vista junto a ella</translation>
    </message>
    <message>
        <source>Cameras for</source>
        <translation>Cámaras para</translation>
    </message>
    <message>
        <source>Sides tried</source>
        <translation>Lados probados</translation>
    </message>
    <message>
        <source>Second view</source>
        <translation>Segunda vista</translation>
    </message>
    <message>
        <source>Off right angle</source>
        <translation>Fuera del ángulo recto</translation>
    </message>
    <message>
        <source>Surface seen</source>
        <translation>Superficie vista</translation>
    </message>
    <message>
        <source>More weights</source>
        <translation>Más pesos</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PresetPicker</name>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nombre del preajuste</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Importar un preajuste</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Preajustes (*.json)</translation>
    </message>
    <message>
        <source>Export the preset</source>
        <translation>Exportar el preajuste</translation>
    </message>
    <message>
        <source>There is a preset &quot;%1&quot;. Replace it?</source>
        <translation>Hay un preajuste «%1». ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Delete the preset &quot;%1&quot;?</source>
        <translation>¿Eliminar el preajuste «%1»?</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>Abrir una función de transferencia</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Funciones de transferencia (*.json)</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Editado</translation>
    </message>
    <message>
        <source>Transfer functions, and your own presets of the whole look</source>
        <translation>Funciones de transferencia y preajustes propios de todo el aspecto</translation>
    </message>
    <message>
        <source>Keep, import, export, rename and delete presets</source>
        <translation>Guardar, importar, exportar, renombrar y eliminar preajustes</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>De un archivo…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>Keep this look as a preset…</source>
        <translation>Guardar este aspecto como preajuste…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Eliminar…</translation>
    </message>
    <message>
        <source>Import a preset…</source>
        <translation>Importar un preajuste…</translation>
    </message>
    <message>
        <source>Export this look…</source>
        <translation>Exportar este aspecto…</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecto</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ReformatPanel</name>
    <message>
        <source>Dra&amp;w</source>
        <translation>&amp;Dibujar</translation>
    </message>
    <message>
        <source>Follow the f&amp;ocus</source>
        <translation>Seguir el f&amp;oco</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>E&amp;liminar</translation>
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
        <translation>Haga clic en puntos de los cortes; Retroceso quita el último, Intro o un doble clic termina el trayecto</translation>
    </message>
    <message>
        <source>Finds the centre line of the tubular structure in focus</source>
        <translation>Busca la línea central de la estructura tubular en foco</translation>
    </message>
    <message>
        <source>Deletes the path</source>
        <translation>Elimina el trayecto</translation>
    </message>
    <message>
        <source>Width of the pictures</source>
        <translation>Anchura de las imágenes</translation>
    </message>
    <message>
        <source>Turns the straightened picture about the path</source>
        <translation>Gira la imagen enderezada alrededor del trayecto</translation>
    </message>
    <message>
        <source>Straightened along the path</source>
        <translation>Enderezada a lo largo del trayecto</translation>
    </message>
    <message>
        <source>Across the path</source>
        <translation>Transversal al trayecto</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Girada</translation>
    </message>
    <message>
        <source>Delete the path</source>
        <translation>Eliminar el trayecto</translation>
    </message>
    <message>
        <source>Bring a label or a region into focus first: a vessel, or another tube.</source>
        <translation>Ponga primero en foco una etiqueta o una región: un vaso u otro tubo.</translation>
    </message>
    <message>
        <source>Path along the focus</source>
        <translation>Trayecto por el foco</translation>
    </message>
    <message>
        <source>The structure in focus is no tube: it is hardly longer than thick. Draw a path instead.</source>
        <translation>La estructura en foco no es un tubo: apenas es más larga que gruesa. Dibuje un trayecto.</translation>
    </message>
    <message numerus="yes">
        <source>%n points; Enter ends the path</source>
        <translation>
            <numerusform>%n punto; Intro termina el trayecto</numerusform>
            <numerusform>%n puntos; Intro termina el trayecto</numerusform>
        </translation>
    </message>
    <message>
        <source>Finding the centre line…</source>
        <translation>Buscando la línea central…</translation>
    </message>
    <message>
        <source>Draw a path on the slices, or follow the vessel that is in focus.</source>
        <translation>Dibuje un trayecto en los cortes, o siga el vaso que está en foco.</translation>
    </message>
    <message>
        <source>At %1 of %2 mm</source>
        <translation>En %1 de %2 mm</translation>
    </message>
    <message>
        <source>Area %1 mm²</source>
        <translation>Área %1 mm²</translation>
    </message>
    <message>
        <source>Radius %1 mm</source>
        <translation>Radio %1 mm</translation>
    </message>
    <message>
        <source>Reading the structure in focus…</source>
        <translation>Leyendo la estructura en foco…</translation>
    </message>
    <message>
        <source>No structure in focus here: no area</source>
        <translation>Aquí no hay estructura en foco: sin área</translation>
    </message>
    <message>
        <source>Cameras follow</source>
        <translation>Las cámaras siguen</translation>
    </message>
    <message>
        <source>Both cameras keep the place on the path in the middle of their pictures as you move along it</source>
        <translation>Ambas cámaras mantienen el lugar del trayecto en el centro de sus imágenes mientras lo recorre</translation>
    </message>
    <message>
        <source>Open along the path</source>
        <translation>Abrir a lo largo del trayecto</translation>
    </message>
    <message>
        <source>The view opens to a tube around the path, which goes along when the path changes</source>
        <translation>La vista se abre hasta un tubo alrededor del trayecto, que lo sigue cuando cambia</translation>
    </message>
    <message>
        <source>Radius of the tube that the view opens to</source>
        <translation>Radio del tubo hasta el que se abre la vista</translation>
    </message>
    <message>
        <source>The tube around the path is in focus: untick Open along the path, and bring a vessel into focus.</source>
        <translation>El tubo alrededor del trayecto es el foco: desmarque «Abrir a lo largo del trayecto» y ponga un vaso en el foco.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionGrower</name>
    <message>
        <source>No region grows from there; click elsewhere.</source>
        <translation>Desde allí no crece ninguna región; haga clic en otro lugar.</translation>
    </message>
    <message>
        <source>Nothing would be left of the region; it stays as it was.</source>
        <translation>No quedaría nada de la región; se queda como estaba.</translation>
    </message>
    <message>
        <source>That is air, which fills more than half of the volume; click a structure.</source>
        <translation>Eso es aire, que llena más de la mitad del volumen; haga clic en una estructura.</translation>
    </message>
    <message>
        <source>No border holds the region there: it would fill more than half of the volume. Drag a ball around the structure (Shift+drag), or click elsewhere.</source>
        <translation>Ningún límite contiene la región allí: llenaría más de la mitad del volumen. Dibuje una bola en torno a la estructura (Mayús+arrastrar) o haga clic en otro lugar.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionPanel</name>
    <message>
        <source>Open the 3-D views to it</source>
        <translation>Abrir las vistas 3D a ella</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>Color de la etiqueta</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Shift+click adds to the region, Ctrl+click takes away. Shift+drag draws a ball around a structure, which its region does not leave.</source>
        <translation>Mayús+clic añade a la región, Ctrl+clic quita. Mayús+arrastrar dibuja una bola en torno a una estructura, de la que su región no sale.</translation>
    </message>
    <message>
        <source>How far values may lie from those at the click (Alt+wheel over a picture, keys , and .)</source>
        <translation>Cuánto pueden apartarse los valores de los del clic (Alt+rueda sobre una imagen, teclas , y .)</translation>
    </message>
    <message>
        <source>Tolerance: how far values may lie below those at the click</source>
        <translation>Tolerancia: cuánto pueden quedar los valores por debajo de los del clic</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>The tolerance is chosen from the plateaus</source>
        <translation>La tolerancia se elige a partir de las mesetas</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the ball around the click, which the region does not leave</source>
        <translation>Radio de la bola en torno al clic, de la que la región no sale</translation>
    </message>
    <message>
        <source>No ball</source>
        <translation>Sin bola</translation>
    </message>
    <message>
        <source>Nothing bounds the region</source>
        <translation>Nada limita la región</translation>
    </message>
    <message>
        <source>Within a ball of</source>
        <translation>Dentro de una bola de</translation>
    </message>
    <message>
        <source>Name of a label</source>
        <translation>Nombre de una etiqueta</translation>
    </message>
    <message>
        <source>Keep the region as a label of this study</source>
        <translation>Conservar la región como etiqueta de este estudio</translation>
    </message>
    <message>
        <source>Region: growing…</source>
        <translation>Región: creciendo…</translation>
    </message>
    <message>
        <source>That is %1 % of the body: the 3-D views do not open to it by themselves.</source>
        <translation>Es el %1 % del cuerpo: las vistas 3D no se abren a ella por sí solas.</translation>
    </message>
    <message>
        <source>The 3-D views do not open to it by themselves.</source>
        <translation>Las vistas 3D no se abren a ella por sí solas.</translation>
    </message>
    <message>
        <source>Region: %1</source>
        <translation>Región: %1</translation>
    </message>
    <message>
        <source>Region: %1 so far…</source>
        <translation>Región: %1 por ahora…</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ResultsDialog</name>
    <message>
        <source>Save results</source>
        <translation>Guardar resultados</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Escribiendo…</translation>
    </message>
    <message>
        <source>Stopped. Nothing was written; an archive keeps what it had taken.</source>
        <translation>Detenido. No se escribió nada; un archivo PACS conserva lo que ya había aceptado.</translation>
    </message>
    <message>
        <source>Measures and the table of labels, as a report</source>
        <translation>Medidas y la tabla de etiquetas, como informe</translation>
    </message>
    <message>
        <source>A structured report (TID 1500): distances, angles, areas and values of the measures, volume and values of each label, and the segmentation that these refer to</source>
        <translation>Un informe estructurado (TID 1500): distancias, ángulos, áreas y valores de las medidas, volumen y valores de cada etiqueta, y la segmentación a la que se refieren</translation>
    </message>
    <message>
        <source>All labels, as a segmentation</source>
        <translation>Todas las etiquetas, como segmentación</translation>
    </message>
    <message>
        <source>With their names and colours</source>
        <translation>Con sus nombres y colores</translation>
    </message>
    <message>
        <source>The focus, as a segmentation</source>
        <translation>El foco, como segmentación</translation>
    </message>
    <message>
        <source>Labels as they are; a region or a range of values as one segment</source>
        <translation>Las etiquetas tal como son; una región o un intervalo de valores como un segmento</translation>
    </message>
    <message>
        <source>A picture of</source>
        <translation>Una imagen de</translation>
    </message>
    <message>
        <source>A secondary capture, which says what makes the picture less than exact</source>
        <translation>Una captura secundaria, que dice qué hace la imagen menos exacta</translation>
    </message>
    <message>
        <source>Views in the picture</source>
        <translation>Vistas en la imagen</translation>
    </message>
    <message>
        <source>A key object selection, which names slices of the series</source>
        <translation>Una selección de objetos clave, que nombra cortes de la serie</translation>
    </message>
    <message>
        <source>by the kind of object</source>
        <translation>según el tipo de objeto</translation>
    </message>
    <message>
        <source>Description of the series</source>
        <translation>Descripción de la serie</translation>
    </message>
    <message>
        <source>To the folder</source>
        <translation>A la carpeta</translation>
    </message>
    <message>
        <source>A file for each object</source>
        <translation>Un fichero para cada objeto</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>Al archivo PACS</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>El servidor responde por cada objeto</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Servidor</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID, also while the window hides them: archives and other programs file them by these.</source>
        <translation>Los objetos contienen el nombre y el ID del paciente, también mientras la ventana los oculta: los archivos PACS y otros programas los ordenan por ellos.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Folder of the results</source>
        <translation>Carpeta de los resultados</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, so there is no DICOM study that this could belong to.</source>
        <translation>Este estudio no proviene de ficheros DICOM, así que no hay estudio DICOM al que pueda pertenecer.</translation>
    </message>
    <message>
        <source>Nothing is in focus.</source>
        <translation>No hay nada en el foco.</translation>
    </message>
    <message>
        <source>The region in focus is not complete yet.</source>
        <translation>La región en foco aún no está completa.</translation>
    </message>
    <message>
        <source>This series was read from an archive file. Unpack it and open the folder.</source>
        <translation>Esta serie se leyó de un fichero comprimido. Descomprímalo y abra la carpeta.</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly: what is shown is interpolated between them.</source>
        <translation>Los cortes de esta serie no están a distancias iguales: lo que se muestra está interpolado entre ellos.</translation>
    </message>
    <message>
        <source>There are no key images (View → Keep a key image).</source>
        <translation>No hay imágenes clave (Ver → Conservar una imagen clave).</translation>
    </message>
    <message>
        <source>The crosshair of no key image lies in the volume.</source>
        <translation>En ninguna imagen clave la cruz está dentro del volumen.</translation>
    </message>
    <message>
        <source>There are neither measures nor labels.</source>
        <translation>No hay ni medidas ni etiquetas.</translation>
    </message>
    <message>
        <source>There are no labels.</source>
        <translation>No hay etiquetas.</translation>
    </message>
    <message>
        <source>No view is on screen.</source>
        <translation>No hay ninguna vista en pantalla.</translation>
    </message>
    <message>
        <source>Slices of the key images: %1</source>
        <translation>Cortes de las imágenes clave: %1</translation>
    </message>
    <message>
        <source>Slices of the key images</source>
        <translation>Cortes de las imágenes clave</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, and archives file by patient and study.</source>
        <translation>Este estudio no proviene de ficheros DICOM, y los archivos PACS ordenan por paciente y estudio.</translation>
    </message>
    <message>
        <source>No server is entered yet (View → Archive).</source>
        <translation>Aún no hay ningún servidor (Ver → Archivo).</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Values %1 to %2 %3</source>
        <translation>Valores de %1 a %2 %3</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Dibujando la imagen…</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>Se escribió %1.</translation>
    </message>
    <message>
        <source>Nothing was sent: %1</source>
        <translation>No se envió nada: %1</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>Pedir al archivo que confirme que los conserva</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb no tiene tal confirmación</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>Un compromiso de almacenamiento (storage commitment): el archivo dice de cada objeto si está guardado con seguridad. La mayoría se conecta para ello a nuestra dirección y puerto, que mientras tanto están abiertos</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>No se confirma que se conserve ninguno: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RetrievalRow</name>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Waits for others</source>
        <translation>Espera a otras</translation>
    </message>
    <message>
        <source>Stops…</source>
        <translation>Deteniendo…</translation>
    </message>
    <message>
        <source>Paused; what came is kept</source>
        <translation>En pausa; lo recibido se conserva</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Completa</translation>
    </message>
    <message>
        <source>Cancels it, and takes it out of the list. What came stays in the cache</source>
        <translation>La cancela y la quita de la lista. Lo recibido queda en la caché</translation>
    </message>
    <message>
        <source>Retrieval %1</source>
        <translation>Recuperación %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Retrievals</name>
    <message>
        <source>The server needs a login.</source>
        <translation>El servidor pide un acceso.</translation>
    </message>
    <message>
        <source>Its server is no longer in the list.</source>
        <translation>Su servidor ya no está en la lista.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SearchForm</name>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Asks the server for the studies that match. Empty fields match all (Return)</source>
        <translation>Pide al servidor los estudios que coinciden. Los campos vacíos coinciden con todos (Intro)</translation>
    </message>
    <message>
        <source>Saved searches</source>
        <translation>Búsquedas guardadas</translation>
    </message>
    <message>
        <source>Searches under a name. A patient&apos;s name, ID and accession number are not saved</source>
        <translation>Búsquedas con un nombre. No se guardan el nombre, el ID ni el número de acceso de un paciente</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Accession</source>
        <translation>Acceso</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripción</translation>
    </message>
    <message>
        <source>An asterisk stands for any text, a question mark for one character</source>
        <translation>Un asterisco representa cualquier texto; un signo de interrogación, un carácter</translation>
    </message>
    <message>
        <source>Family name, or &quot;Doe, Jane&quot;: all names that begin so. %1, as in *jane*</source>
        <translation>Apellido, o «Doe, Jane»: todos los nombres que empiezan así. %1, como en *jane*</translation>
    </message>
    <message>
        <source>The patient&apos;s ID as it is. %1, as in 47*</source>
        <translation>El ID del paciente tal como es. %1, como en 47*</translation>
    </message>
    <message>
        <source>The accession number as it is. %1, as in A2024*</source>
        <translation>El número de acceso tal como es. %1, como en A2024*</translation>
    </message>
    <message>
        <source>All descriptions of studies that hold this text. %1, as in head*</source>
        <translation>Todas las descripciones de estudios que contienen este texto. %1, como en head*</translation>
    </message>
    <message>
        <source>The kind of images that the study holds</source>
        <translation>El tipo de imágenes que contiene el estudio</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Cualquiera</translation>
    </message>
    <message>
        <source>When the study was made</source>
        <translation>Cuándo se hizo el estudio</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Hoy</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Últimos 7 días</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Últimos 30 días</translation>
    </message>
    <message>
        <source>Last 365 days</source>
        <translation>Últimos 365 días</translation>
    </message>
    <message>
        <source>From … to</source>
        <translation>De … a</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Primer día</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Último día</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Save this search…</source>
        <translation>Guardar esta búsqueda…</translation>
    </message>
    <message>
        <source>Save this search</source>
        <translation>Guardar esta búsqueda</translation>
    </message>
    <message>
        <source>Its name (date, type and description are saved, nothing of a patient):</source>
        <translation>Su nombre (se guardan fecha, tipo y descripción, nada de un paciente):</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Olvidar</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SendDialog</name>
    <message>
        <source>Nothing is open.</source>
        <translation>No hay nada abierto.</translation>
    </message>
    <message>
        <source>What is open is not DICOM, and archives keep nothing else.</source>
        <translation>Lo abierto no es DICOM, y los archivos no guardan otra cosa.</translation>
    </message>
    <message>
        <source>Send to an archive</source>
        <translation>Enviar a un archivo</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Enviar</translation>
    </message>
    <message>
        <source>The server that gets the objects</source>
        <translation>El servidor que recibe los objetos</translation>
    </message>
    <message>
        <source>The open series, images: %1</source>
        <translation>La serie abierta, imágenes: %1</translation>
    </message>
    <message>
        <source>Its files as they are</source>
        <translation>Sus archivos tal como son</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>Todas las etiquetas, como segmentación DICOM</translation>
    </message>
    <message>
        <source>With their names and colours, for the patient and the series that are open</source>
        <translation>Con sus nombres y colores, para el paciente y la serie abiertos</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID: an archive files them by these.</source>
        <translation>Los objetos contienen el nombre y el ID del paciente: un archivo los clasifica por ellos.</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Servidor</translation>
    </message>
    <message>
        <source>Image %1</source>
        <translation>Imagen %1</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>Pedir al archivo que confirme que los conserva</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb no tiene tal confirmación</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>Un compromiso de almacenamiento (storage commitment): el archivo dice de cada objeto si está guardado con seguridad. La mayoría se conecta para ello a nuestra dirección y puerto, que mientras tanto están abiertos</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>No se confirma que se conserve ninguno: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SentAnswers</name>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Answer of the server</source>
        <translation>Respuesta del servidor</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>aceptado</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>Accepted: %1 of %2.</source>
        <translation>Aceptados: %1 de %2.</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservado</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>no conservado: %1</translation>
    </message>
    <message>
        <source>not confirmed to be kept</source>
        <translation>conservación no confirmada</translation>
    </message>
    <message>
        <source>Confirmed to be kept: %1 of %2.</source>
        <translation>Conservación confirmada: %1 de %2.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SeriesPanel</name>
    <message>
        <source>Series</source>
        <translation>Series</translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>Paciente %1</translation>
    </message>
    <message>
        <source>Patient without a name</source>
        <translation>Paciente sin nombre</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 imagen</translation>
    </message>
    <message numerus="yes">
        <source>%n images</source>
        <translation>
            <numerusform>%n imagen</numerusform>
            <numerusform>%n imágenes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1, abierta</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open beside</source>
        <translation>Abrir al lado</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ServerDialog</name>
    <message>
        <source>Archive server</source>
        <translation>Servidor de archivo</translation>
    </message>
    <message>
        <source>As you call it</source>
        <translation>Como usted lo llama</translation>
    </message>
    <message>
        <source>DICOM</source>
        <translation>DICOM</translation>
    </message>
    <message>
        <source>DICOM over TLS</source>
        <translation>DICOM sobre TLS</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>What the server speaks; its administrator knows</source>
        <translation>Lo que habla el servidor; su administrador lo sabe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Speaks</source>
        <translation>Habla</translation>
    </message>
    <message>
        <source>Its name or address in the network</source>
        <translation>Su nombre o dirección en la red</translation>
    </message>
    <message>
        <source>The port that it listens on</source>
        <translation>El puerto en el que escucha</translation>
    </message>
    <message>
        <source>Its AE title, at most 16 letters and digits</source>
        <translation>Su título AE, 16 letras y cifras como máximo</translation>
    </message>
    <message>
        <source>Our AE title: its administrator enters it at the server</source>
        <translation>El título AE propio: el administrador lo registra en el servidor</translation>
    </message>
    <message>
        <source>C-GET, over our connection</source>
        <translation>C-GET, por nuestra conexión</translation>
    </message>
    <message>
        <source>C-MOVE, the server connects to us</source>
        <translation>C-MOVE, el servidor se conecta con nosotros</translation>
    </message>
    <message>
        <source>How objects come. C-GET needs nothing more; with C-MOVE our address and port are entered at the server, and the port is open while objects come</source>
        <translation>Cómo llegan los objetos. C-GET no necesita nada más; con C-MOVE la dirección y el puerto propios se registran en el servidor, y el puerto está abierto mientras llegan objetos</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>Its AE title</source>
        <translation>Su título AE</translation>
    </message>
    <message>
        <source>Our AE title</source>
        <translation>Título AE propio</translation>
    </message>
    <message>
        <source>Retrieve by</source>
        <translation>Recuperar por</translation>
    </message>
    <message>
        <source>Our address</source>
        <translation>Dirección propia</translation>
    </message>
    <message>
        <source>Our port</source>
        <translation>Puerto propio</translation>
    </message>
    <message>
        <source>The address of DICOMweb&apos;s root. A login goes out over https alone</source>
        <translation>La dirección de la raíz de DICOMweb. Un acceso solo sale por https</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>User and password</source>
        <translation>Usuario y contraseña</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>Who you are to the server</source>
        <translation>Quién es usted para el servidor</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Acceso</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Certificates that may sign the server&apos;s</source>
        <translation>Certificados que pueden firmar el del servidor</translation>
    </message>
    <message>
        <source>Certificates in PEM that may sign the server&apos;s, or its own</source>
        <translation>Certificados en PEM que pueden firmar el del servidor, o el suyo</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>Certificado propio</translation>
    </message>
    <message>
        <source>In PEM, where the server asks for one</source>
        <translation>En PEM, si el servidor pide uno</translation>
    </message>
    <message>
        <source>The key of our certificate</source>
        <translation>La clave del certificado propio</translation>
    </message>
    <message>
        <source>In PEM, without a passphrase</source>
        <translation>En PEM, sin frase de contraseña</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Certificados de confianza</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>Su clave</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Elegir el archivo</translation>
    </message>
    <message>
        <source>Certificates and keys (*.pem *.crt *.cer *.key);;All files (*)</source>
        <translation>Certificados y claves (*.pem *.crt *.cer *.key);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Token for %1:</source>
        <translation>Token para %1:</translation>
    </message>
    <message>
        <source>Password of %1 for %2:</source>
        <translation>Contraseña de %1 para %2:</translation>
    </message>
    <message>
        <source>Address of this machine that the server sends to: objects by C-MOVE, and whether it keeps what it was sent</source>
        <translation>Dirección de este equipo a la que envía el servidor: objetos por C-MOVE, y si conserva lo que se le envió</translation>
    </message>
    <message>
        <source>Port of this machine that the server sends to; it is open while that is waited for</source>
        <translation>Puerto de este equipo al que envía el servidor; está abierto mientras se espera</translation>
    </message>
    <message>
        <source>The password or token is asked for when it is needed</source>
        <translation>La contraseña o el token se pide cuando hace falta</translation>
    </message>
    <message>
        <source>Keep the password or token in the key ring</source>
        <translation>Guardar la contraseña o el token en el llavero</translation>
    </message>
    <message>
        <source>The password or token is kept where the desktop keeps those of other programs, encrypted, and nowhere else. Otherwise it is forgotten when the program ends</source>
        <translation>La contraseña o el token se guarda donde el escritorio guarda los de otros programas, cifrado, y en ningún otro sitio. Si no, se olvida al terminar el programa</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Sessions</name>
    <message>
        <source>Sessions</source>
        <translation>Sesiones</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Trabajo sin guardar</translation>
    </message>
    <message>
        <source>These changes since the last save would be lost. Save them?</source>
        <translation>Estos cambios desde el último guardado se perderían. ¿Guardarlos?</translation>
    </message>
    <message>
        <source>Where is the data now?</source>
        <translation>¿Dónde están ahora los datos?</translation>
    </message>
    <message>
        <source>The session&apos;s label map is needed.</source>
        <translation>Se necesita el mapa de etiquetas de la sesión.</translation>
    </message>
    <message>
        <source>The session&apos;s volume is needed.</source>
        <translation>Se necesita el volumen de la sesión.</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Elegir un archivo…</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Elegir una carpeta…</translation>
    </message>
    <message>
        <source>The data</source>
        <translation>Los datos</translation>
    </message>
    <message>
        <source>The data&apos;s folder</source>
        <translation>La carpeta de los datos</translation>
    </message>
    <message>
        <source>%1 %2. Say it here:</source>
        <translation>%1 %2. Indíquelo aquí:</translation>
    </message>
    <message>
        <source>Fenestra ended before the session was saved. A copy from %1 can be restored.</source>
        <translation>Fenestra terminó antes de guardar la sesión. Se puede restaurar una copia de %1.</translation>
    </message>
    <message>
        <source>Fenestra ended before the work on %1 was saved. A copy from %2 can be restored.</source>
        <translation>Fenestra terminó antes de guardar el trabajo en %1. Se puede restaurar una copia de %2.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Preguntar luego</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Guardar la sesión</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Abrir una sesión</translation>
    </message>
    <message>
        <source>The labels that you kept are in no file yet, and reading the data again would drop them. Save the session first.</source>
        <translation>Las etiquetas que conservó no están aún en ningún archivo, y volver a leer los datos las perdería. Guarde primero la sesión.</translation>
    </message>
    <message>
        <source>The restored work</source>
        <translation>El trabajo restaurado</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SliceView</name>
    <message>
        <source>Not yet as asked for</source>
        <translation>Aún no es lo pedido</translation>
    </message>
    <message>
        <source>Interpolated, not scanned</source>
        <translation>Interpolado, no adquirido</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Radiological</source>
        <translation>Radiológica</translation>
    </message>
    <message>
        <source>L %1</source>
        <translation>N %L1</translation>
    </message>
    <message>
        <source>W %1</source>
        <translation>A %L1</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>invertido</translation>
    </message>
    <message>
        <source>Oblique, %1° from %2</source>
        <translation>Oblicuo, %1° de %2</translation>
    </message>
    <message>
        <source>Faces C1, %1° from %2</source>
        <translation>Frente a C1, %1° de %2</translation>
    </message>
    <message>
        <source>Faces C2, %1° from %2</source>
        <translation>Frente a C2, %1° de %2</translation>
    </message>
    <message>
        <source>Neurological</source>
        <translation>Neurológica</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>volteado</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>girado %1°</translation>
    </message>
    <message>
        <source>true size</source>
        <translation>tamaño real</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SpacingDialog</name>
    <message>
        <source>Size of the voxels</source>
        <translation>Tamaño de los vóxeles</translation>
    </message>
    <message>
        <source>&amp;Across a row</source>
        <translation>&amp;A lo largo de una fila</translation>
    </message>
    <message>
        <source>&amp;Down a column</source>
        <translation>A &amp;lo largo de una columna</translation>
    </message>
    <message>
        <source>From &amp;slice to slice</source>
        <translation>&amp;De corte a corte</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>no indicado</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SphereMap</name>
    <message>
        <source>How good each viewpoint is, from dark to bright; click to look from there</source>
        <translation>Cuán bueno es cada punto de vista, de oscuro a claro; clic para mirar desde allí</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StatusBar</name>
    <message>
        <source>Software OpenGL</source>
        <translation>OpenGL por software</translation>
    </message>
    <message>
        <source>Pictures are smaller while something moves: %1 draws them</source>
        <translation>Las imágenes son menores mientras algo se mueve: las dibuja %1</translation>
    </message>
    <message>
        <source>No OpenGL: slices only</source>
        <translation>Sin OpenGL: solo cortes</translation>
    </message>
    <message>
        <source>Time until the last picture was on screen, and its sampling</source>
        <translation>Tiempo hasta mostrarse la última imagen, y su muestreo</translation>
    </message>
    <message>
        <source>Radiological convention</source>
        <translation>Convención radiológica</translation>
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
        <translation>, %1 % del tamaño</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>Convención neurológica</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StrokeList</name>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>Borrar todo</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Cargar…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Tick the strokes to apply</source>
        <translation>Marque los trazos que se aplican</translation>
    </message>
    <message>
        <source>Adds the strokes of a file</source>
        <translation>Añade los trazos de un archivo</translation>
    </message>
    <message>
        <source>Clear strokes</source>
        <translation>Borrar trazos</translation>
    </message>
    <message>
        <source>Load brush strokes</source>
        <translation>Cargar trazos de pincel</translation>
    </message>
    <message>
        <source>Brush strokes (*.json)</source>
        <translation>Trazos de pincel (*.json)</translation>
    </message>
    <message>
        <source>Brush strokes</source>
        <translation>Trazos de pincel</translation>
    </message>
    <message>
        <source>Save brush strokes</source>
        <translation>Guardar trazos de pincel</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Eliminar trazo</translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>Eliminar trazos</translation>
    </message>
    <message>
        <source>Load strokes</source>
        <translation>Cargar trazos</translation>
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
        <translation>hasta la superficie</translation>
    </message>
    <message>
        <source>%1 mm deep</source>
        <translation>%L1 mm de profundidad</translation>
    </message>
    <message>
        <source>over the focus</source>
        <translation>sobre el foco</translation>
    </message>
    <message>
        <source>C%1 only</source>
        <translation>solo C%1</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>Ocultar trazo</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>Mostrar trazo</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyLinkBar</name>
    <message>
        <source>Link</source>
        <translation>Vincular</translation>
    </message>
    <message>
        <source>The crosshair, scrolling, zoom and turning of one study go along with those of the other, by patient position</source>
        <translation>La cruz, el desplazamiento, el zoom y el giro de un estudio siguen a los del otro, por la posición del paciente</translation>
    </message>
    <message>
        <source>Match points</source>
        <translation>Emparejar puntos</translation>
    </message>
    <message>
        <source>The crosshairs of both studies mark the same point: link the studies by it</source>
        <translation>Las cruces de ambos estudios marcan el mismo punto: vincular los estudios por él</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Forget the pair of points: the same coordinates are the same point</source>
        <translation>Olvidar el par de puntos: las mismas coordenadas son el mismo punto</translation>
    </message>
    <message>
        <source>not linked</source>
        <translation>sin vincular</translation>
    </message>
    <message>
        <source>linked by patient position</source>
        <translation>vinculado por la posición del paciente</translation>
    </message>
    <message>
        <source>linked, offset %1, %2, %3 mm</source>
        <translation>vinculado, desfase %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>Offset of the other study to the patient&apos;s left, posterior and superior</source>
        <translation>Desfase del otro estudio hacia la izquierda, atrás y arriba del paciente</translation>
    </message>
    <message>
        <source>Left study</source>
        <translation>Estudio izquierdo</translation>
    </message>
    <message>
        <source>Right study</source>
        <translation>Estudio derecho</translation>
    </message>
    <message>
        <source>%1, active</source>
        <translation>%1, activo</translation>
    </message>
    <message>
        <source>%1 mm apart, where a study ends</source>
        <translation>a %1 mm, donde termina un estudio</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyNotices</name>
    <message numerus="yes">
        <source>There are %n time points here; this is number %1.</source>
        <translation>
            <numerusform>Aquí hay %n instante; este es el número %1.</numerusform>
            <numerusform>Aquí hay %n instantes; este es el número %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n series here; open is %1.</source>
        <translation>
            <numerusform>Aquí hay %n serie; está abierta %1.</numerusform>
            <numerusform>Aquí hay %n series; está abierta %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>A segmentation of this series lies beside it: %1.</source>
        <translation>Junto a ella hay una segmentación de esta serie: %1.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message numerus="yes">
        <source>%n segmentations of this series lie beside it.</source>
        <translation>
            <numerusform>Junto a ella hay %n segmentación de esta serie.</numerusform>
            <numerusform>Junto a ella hay %n segmentaciones de esta serie.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TagsPanel</name>
    <message>
        <source>Search tags, names and values</source>
        <translation>Buscar atributos, nombres y valores</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>Atributos DICOM</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>This study is no DICOM series: its format is %1, which has no DICOM tags.</source>
        <translation>Este estudio no es una serie DICOM: su formato es %1, que no tiene atributos DICOM.</translation>
    </message>
    <message>
        <source>This series was read from an archive. Unpack it and open the folder to see its tags.</source>
        <translation>Esta serie se leyó de un archivo comprimido. Descomprímalo y abra la carpeta para ver sus atributos.</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly. What is shown is interpolated between them, and no file holds it.</source>
        <translation>Los cortes de esta serie no están espaciados por igual. Lo que se muestra se interpola entre ellos y ningún archivo lo contiene.</translation>
    </message>
    <message>
        <source>This plane is turned and crosses several files. Reset it (View → Slices), or click another view.</source>
        <translation>Este plano está girado y cruza varios archivos. Restablézcalo (Ver → Cortes) o haga clic en otra vista.</translation>
    </message>
    <message>
        <source>The file of this slice cannot be read.</source>
        <translation>No se puede leer el archivo de este corte.</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Corte %1 de %2</translation>
    </message>
    <message>
        <source>%1, at the crosshair</source>
        <translation>%1, en la cruz</translation>
    </message>
    <message>
        <source>1 item</source>
        <translation>1 elemento</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n elemento</numerusform>
            <numerusform>%n elementos</numerusform>
        </translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>Item %1</source>
        <translation>Elemento %1</translation>
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
        <translation>Volumen de la región frente a su tolerancia, ambos logarítmicos. Un acantilado es una fuga; el verde marca donde la región apenas cambia</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Tour</name>
    <message>
        <source>End the tour</source>
        <translation>Terminar la visita</translation>
    </message>
    <message>
        <source>One body, five views</source>
        <translation>Un cuerpo, cinco vistas</translation>
    </message>
    <message>
        <source>Above are two 3-D views, C1 and C2; below are three slices. The torso opens with several structures in focus: what hides them is cut away.</source>
        <translation>Arriba hay dos vistas 3D, C1 y C2; abajo, tres cortes. El torso se abre con varias estructuras en el foco: lo que las oculta está cortado.</translation>
    </message>
    <message>
        <source>Choose a structure</source>
        <translation>Elegir una estructura</translation>
    </message>
    <message>
        <source>A click on the left kidney in the axial slice makes it the focus. The cameras move to the two views that together see most of it.</source>
        <translation>Un clic en el riñón izquierdo del corte axial lo convierte en el foco. Las cámaras van a las dos vistas que juntas ven más de él.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Drag with the left button in a 3-D view to turn it. The opening follows the kidney; C2 follows C1.</source>
        <translation>Arrastre con el botón izquierdo en una vista 3D para girarla. La abertura sigue al riñón; C2 sigue a C1.</translation>
    </message>
    <message>
        <source>Widen the opening</source>
        <translation>Ensanchar la abertura</translation>
    </message>
    <message>
        <source>The slider Opening in the panel Cutaway sets how far the opening reaches beyond the focus.</source>
        <translation>El control Abertura del panel Seccionado fija cuánto se extiende la abertura más allá del foco.</translation>
    </message>
    <message>
        <source>Bring tissue back</source>
        <translation>Devolver tejido</translation>
    </message>
    <message>
        <source>The brush (P) paints back what the opening removed: here, tissue above the kidney. Ctrl+Z takes a stroke back.</source>
        <translation>El pincel (P) devuelve lo que quitó la abertura: aquí, tejido sobre el riñón. Ctrl+Z deshace un trazo.</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Conservarlo</translation>
    </message>
    <message>
        <source>Ctrl+S saves a session with all that you did; Ctrl+E saves a picture, for a slide. F1 opens the user guide.</source>
        <translation>Ctrl+S guarda una sesión con todo lo hecho; Ctrl+E guarda una imagen, para una diapositiva. F1 abre la guía del usuario.</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 de %2: %3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TransferFunctionEditor</name>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>Color del punto elegido</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Por valor</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>Abrir una función de transferencia</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Funciones de transferencia (*.json)</translation>
    </message>
    <message>
        <source>What the plot shows and edits</source>
        <translation>Qué muestra y edita el gráfico</translation>
    </message>
    <message>
        <source>Drag points, or the edges, top and inside of a trapezoid. Double-click adds a point; Delete removes it; the wheel enlarges. The key ? lists all.</source>
        <translation>Arrastre puntos, o los lados, la cima y el interior de un trapecio. Doble clic añade un punto; Supr lo elimina; la rueda amplía. La tecla ? lo enumera todo.</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>Valor del punto elegido</translation>
    </message>
    <message>
        <source>Opacity of 1 mm at the selected point</source>
        <translation>Opacidad de 1 mm en el punto elegido</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Shows this part of the focus by a function of the values, as the context is shown, in place of one colour and opacity</source>
        <translation>Muestra esta parte del foco por una función de los valores, como el contexto, en lugar de un color y una opacidad</translation>
    </message>
    <message>
        <source>From a preset</source>
        <translation>De un preajuste</translation>
    </message>
    <message>
        <source>Takes the function of a preset for this part of the focus</source>
        <translation>Toma la función de un preajuste para esta parte del foco</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>De un archivo…</translation>
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
        <translation>Función de transferencia sobre el histograma</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Color…</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Eliminar el punto</translation>
    </message>
    <message>
        <source>Delete the trapezoid</source>
        <translation>Eliminar el trapecio</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Añadir un punto</translation>
    </message>
    <message>
        <source>Add a trapezoid</source>
        <translation>Añadir un trapecio</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Por valor</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Mostrar todos los valores</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Verification</name>
    <message>
        <source>Computed again in double precision: %1 pixels, drawn at random (seed %2). Beyond that: %3. Greatest difference: %4/255.</source>
        <translation>Recalculado con doble precisión: %1 píxeles elegidos al azar (semilla %2). Por encima: %3. Mayor diferencia: %4/255.</translation>
    </message>
    <message>
        <source>%1 % of the pixels are within %2/255 of the exact picture: all were computed again.</source>
        <translation>El %1 % de los píxeles está a menos de %2/255 de la imagen exacta: se recalcularon todos.</translation>
    </message>
    <message>
        <source>At least %1 % of the pixels are within %2/255 of the exact picture, with %3 % confidence.</source>
        <translation>Al menos el %1 % de los píxeles está a menos de %2/255 de la imagen exacta, con un %3 % de confianza.</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could be verified.</source>
        <translation>No hay en pantalla ninguna vista 3D que verificar.</translation>
    </message>
    <message>
        <source>The picture is verified once it is drawn at full quality.</source>
        <translation>La imagen se verifica cuando está dibujada con plena calidad.</translation>
    </message>
    <message>
        <source>Verify this picture</source>
        <translation>Verificar esta imagen</translation>
    </message>
    <message>
        <source>&amp;Save the picture…</source>
        <translation>&amp;Guardar la imagen…</translation>
    </message>
    <message>
        <source>Save the picture with its certificate</source>
        <translation>Guardar la imagen con su certificado</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Se escribió %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewArea</name>
    <message>
        <source>3-D views are not available here.

%1

The slices work without it.</source>
        <translation>Las vistas 3D no están disponibles aquí.

%1

Los cortes funcionan sin ellas.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewCommands</name>
    <message>
        <source>Standard view</source>
        <translation>Vista estándar</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Restablecer vista</translation>
    </message>
    <message>
        <source>Reset views</source>
        <translation>Restablecer vistas</translation>
    </message>
    <message>
        <source>Freeze the opening</source>
        <translation>Congelar la abertura</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::VolumeView</name>
    <message>
        <source>The 3-D views cannot be drawn. %1</source>
        <translation>No se pueden dibujar las vistas 3D. %1</translation>
    </message>
    <message>
        <source>The first 3-D picture of this study is being made…</source>
        <translation>Se está creando la primera imagen 3D de este estudio…</translation>
    </message>
    <message>
        <source>Editing the label; the one before still shows</source>
        <translation>Editando la etiqueta; sigue a la vista la anterior</translation>
    </message>
    <message>
        <source>Not yet as asked for: the picture is being prepared</source>
        <translation>Aún no es lo pedido: la imagen se está preparando</translation>
    </message>
    <message>
        <source>Waits for the picture</source>
        <translation>Espera la imagen</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspectiva</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>paralela</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WaitingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Take back what the pictures do not show yet</source>
        <translation>Retirar lo que las imágenes aún no muestran</translation>
    </message>
    <message>
        <source>Preparing the picture, %1 s</source>
        <translation>Preparando la imagen, %1 s</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WelcomePage</name>
    <message>
        <source>3-D views are not available here; slices work. %1</source>
        <translation>Las vistas 3D no están disponibles aquí; los cortes funcionan. %1</translation>
    </message>
    <message>
        <source>No graphics card was found: the processor draws the 3-D views, in smaller pictures while something moves. (%1)</source>
        <translation>No se encontró tarjeta gráfica: el procesador dibuja las vistas 3D, en imágenes menores mientras algo se mueve. (%1)</translation>
    </message>
    <message>
        <source>The graphics card draws the 3-D views. (%1)</source>
        <translation>La tarjeta gráfica dibuja las vistas 3D. (%1)</translation>
    </message>
    <message>
        <source>Choose a structure in a CT or MR, and the tissue in front of it opens. &lt;b&gt;Not for diagnostic use.&lt;/b&gt;</source>
        <translation>Elija una estructura en una TC o RM, y el tejido que la cubre se abre. &lt;b&gt;No apto para uso diagnóstico.&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>Abierto por última vez</translation>
    </message>
    <message>
        <source>User guide (F1)</source>
        <translation>Guía del usuario (F1)</translation>
    </message>
    <message>
        <source>Built-in phantoms</source>
        <translation>Fantomas incorporados</translation>
    </message>
    <message>
        <source>Bodies made of simple shapes, with every structure labelled. Nobody&apos;s data: try everything on them.</source>
        <translation>Cuerpos de formas simples, con todas sus estructuras etiquetadas. No son datos de nadie: pruébelo todo en ellos.</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>Visita guiada</translation>
    </message>
    <message>
        <source>Clicks through the first minute on the torso phantom, and says at each step what it does.</source>
        <translation>Recorre el primer minuto con el fantoma del torso y dice en cada paso lo que hace.</translation>
    </message>
    <message>
        <source>Your own data</source>
        <translation>Sus propios datos</translation>
    </message>
    <message>
        <source>Drop a folder of DICOM files, or a NIfTI, NRRD or MetaImage file, anywhere in this window.</source>
        <translation>Suelte una carpeta de archivos DICOM, o un archivo NIfTI, NRRD o MetaImage, en cualquier lugar de esta ventana.</translation>
    </message>
    <message>
        <source>Start the tour</source>
        <translation>Iniciar la visita</translation>
    </message>
    <message>
        <source>Open a folder…</source>
        <translation>Abrir una carpeta…</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Abrir un archivo…</translation>
    </message>
    <message>
        <source>session</source>
        <translation>sesión</translation>
    </message>
    <message>
        <source>study</source>
        <translation>estudio</translation>
    </message>
    <message>
        <source>%1 %2, name hidden</source>
        <translation>%1 %2, nombre oculto</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WindowLevelDialog</name>
    <message>
        <source>Window and level</source>
        <translation>Ventana y nivel</translation>
    </message>
    <message>
        <source>&amp;Invert: low values bright</source>
        <translation>&amp;Invertir: valores bajos claros</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Ancho</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Nivel</translation>
    </message>
</context>
</TS>
